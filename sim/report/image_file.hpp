#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace maquette::sim {

/// A picture as the frame memory shows it: rows from the top, each pixel red, green, blue.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3
};

/// The picture as the bytes of a PNG file: 24 bits per pixel, nothing besides the pixels, the same
/// bytes for the same picture. Throws std::invalid_argument when `rgb` has not the stated size, or
/// the picture is empty.
std::string encode_png(const Picture& picture);

/// The picture in the bytes of a PNG file of three 8-bit channels. `name` is that of the file, for
/// the error message. Throws DescriptionError.
Picture decode_png(const std::string& bytes, const std::string& name);

}  // namespace maquette::sim
