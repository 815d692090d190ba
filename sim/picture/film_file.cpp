#include "sim/picture/film_file.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sim/picture/animated_png.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/picture/picture_module.hpp"
#include "sim/picture/png_codec.hpp"
#include "sim/picture_module/film_codec.hpp"

namespace maquette::sim {

namespace {

constexpr int k_channels = 3;

const FilmCodec& codec() {
  static const FilmCodec& loaded =
      *reinterpret_cast<const FilmCodec* (*)()>(picture_module_function(k_film_codec_function))();
  return loaded;
}

void check_done(const std::string& error) {
  if (!error.empty()) {
    throw std::runtime_error(error);
  }
}

DrawnPicture drawn(const FilmPicture& film) {
  DrawnPicture result{film.picture.width, film.picture.height, {}};
  result.channels.reserve(film.picture.pixels.size() * k_channels);
  for (const std::uint32_t pixel : film.picture.pixels) {
    for (const int shift : {16, 8, 0}) {
      result.channels.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  if (!film.caption.empty()) {
    check_done(codec().caption(film.caption, result));
  }
  return result;
}

}  // namespace

std::string encode_film(double pictures_per_s, const NextFilmPicture& next) {
  std::string bytes;
  check_done(codec().encode_gif(
      pictures_per_s,
      [&next](DrawnPicture& picture) {
        FilmPicture film;
        if (!next(film)) {
          return false;
        }
        picture = drawn(film);
        return true;
      },
      bytes));
  return bytes;
}

std::string encode_png_film(double pictures_per_s, const NextFilmPicture& next) {
  std::vector<std::string> pictures;
  for (FilmPicture film; next(film);) {
    pictures.push_back(encode_film_picture(film));
  }
  return animated_png(pictures, pictures_per_s);
}

std::string encode_film_picture(const FilmPicture& film) {
  if (film.caption.empty()) {
    return encode_png(film.picture);
  }
  DrawnPicture picture = drawn(film);
  return encode({static_cast<std::uint32_t>(picture.width),
                 static_cast<std::uint32_t>(picture.height), k_channels, 8,
                 std::move(picture.channels)});
}

}  // namespace maquette::sim
