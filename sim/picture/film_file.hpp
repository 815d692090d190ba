#pragma once

#include <functional>
#include <string>

#include "models/display/picture.hpp"

namespace maquette::sim {

/// A picture of a film, and what stands in its corner; empty: nothing.
struct FilmPicture {
  models::Picture picture;
  std::string caption;
};

/// Gives the next picture of a film, all of one size; false at its end.
using NextFilmPicture = std::function<bool(FilmPicture& picture)>;

/// The pictures as the bytes of an animated GIF that begins again at its end. Throws
/// std::runtime_error.
std::string encode_film(double pictures_per_s, const NextFilmPicture& next);

/// The same as the bytes of an animated PNG: larger, with all colours, and twenty times faster.
std::string encode_png_film(double pictures_per_s, const NextFilmPicture& next);

/// The picture with its caption as the bytes of a PNG file. Throws std::runtime_error.
std::string encode_film_picture(const FilmPicture& film);

}  // namespace maquette::sim
