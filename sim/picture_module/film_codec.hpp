#pragma once

#include <functional>
#include <string>

#include "sim/picture_module/map_drawing.hpp"

namespace maquette::sim {

/// Gives the next picture of a film, all of one size; false at its end.
using NextPicture = std::function<bool(DrawnPicture& picture)>;

/// Films by OpenImageIO, in the module of ExrCodec. Both return what went wrong, nothing when all
/// is well.
struct FilmCodec {
  /// Writes a line of text into the lower left corner, white on black.
  std::string (*caption)(const std::string& text, DrawnPicture& picture);
  /// The pictures one after the other as an animated GIF, whose palettes have 256 colours.
  std::string (*encode_gif)(double pictures_per_s, const NextPicture& next, std::string& bytes);
};

/// The name of the function in the module that returns its codec.
inline constexpr const char* k_film_codec_function = "maquette_film_codec";

}  // namespace maquette::sim
