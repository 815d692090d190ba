#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace maquette::sim {

/// Rows from the top, pixels from the left, three 8-bit channels red, green, blue.
struct PngImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> channels;
};

/// Rows from the top, pixels from the left, one 16-bit channel.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> values;
};

/// PNG by OpenImageIO, in a module of its own that is loaded when the first picture is written or
/// read: the library brings some 250 others, whose loading takes longer than many a simulation.
/// All return what went wrong, nothing when all is well.
struct PngCodec {
  std::string (*encode)(const PngImage& image, std::string& bytes);
  std::string (*decode)(const std::string& bytes, PngImage& image);
  std::string (*encode_grey)(const GreyImage& image, std::string& bytes);
  std::string (*decode_grey)(const std::string& bytes, GreyImage& image);
};

/// The name of the function in the module that returns its codec.
inline constexpr const char* k_png_codec_function = "maquette_png_codec";

}  // namespace maquette::sim
