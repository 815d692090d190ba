#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace maquette::sim {

/// How the values of a channel are stored.
enum class ExrStorage {
  code,   ///< whole numbers 0..255 of a picture, stored as halves of code / 255
  count,  ///< 32-bit whole numbers
  real    ///< 32-bit floating point numbers, whose bits are the values
};

/// One channel: a value per pixel of the data window, rows from the top.
struct ExrChannel {
  std::string name;
  ExrStorage storage = ExrStorage::count;
  std::vector<std::uint32_t> values;
};

/// A picture of many channels of which only a rectangle, the data window, holds data.
struct ExrImage {
  int width = 0;  ///< of the whole picture
  int height = 0;
  int data_column = 0;  ///< left edge of the data window
  int data_row = 0;
  int data_width = 0;
  int data_height = 0;
  std::vector<ExrChannel> channels;               ///< decoding asks for these, by name and storage
  std::map<std::string, std::string> attributes;  ///< of the file's header
};

/// OpenEXR files by OpenImageIO, in a module of its own that is loaded when the first record is
/// written or read: the library brings some 250 others, whose loading takes longer than many a
/// simulation. Both return what went wrong, nothing when all is well. `decode` fills the channels
/// that `image` names and the attributes of which it has the names.
struct ExrCodec {
  std::string (*encode)(const ExrImage& image, std::string& bytes);
  std::string (*decode)(const std::string& bytes, ExrImage& image);
};

/// The name of the function in the module that returns its codec.
inline constexpr const char* k_exr_codec_function = "maquette_exr_codec";

}  // namespace maquette::sim
