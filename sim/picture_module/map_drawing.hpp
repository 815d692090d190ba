#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace maquette::sim {

/// A mark of a scale, and what stands beside it.
struct MapTick {
  float value = 0;
  std::string label;
};

/// A map of numbers to be drawn: in colours, with a title above it and a scale beside it, or, where
/// the numbers stand for names, a legend.
struct MapDrawing {
  int width = 0;
  int height = 0;
  std::vector<float> values;  ///< rows from the top; not a number: nothing is known
  std::string title;
  std::string subtitle;
  std::string unit;  ///< above the scale
  float low = 0;     ///< of the scale
  float high = 1;
  std::vector<MapTick> ticks;
  std::vector<std::string> names;  ///< of the values 0, 1, 2 ...; empty: the values are numbers
};

/// Rows from the top, pixels from the left, three 8-bit channels red, green, blue.
struct DrawnPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> channels;
};

/// Draws by OpenImageIO, in the module of ExrCodec. Returns what went wrong, nothing when all is
/// well.
struct MapCodec {
  std::string (*draw)(const MapDrawing& drawing, DrawnPicture& picture);
};

/// The name of the function in the module that returns its codec.
inline constexpr const char* k_map_codec_function = "maquette_map_codec";

}  // namespace maquette::sim
