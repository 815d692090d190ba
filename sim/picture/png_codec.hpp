#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace maquette::sim {

/// What a PNG file holds: rows from the top, pixels from the left, of so many channels of so many
/// bits, 8 or 16, the first byte of which is the highest.
struct PngImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 0;
  int bits = 8;
  std::vector<std::uint8_t> bytes;

  [[nodiscard]] std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels * bits / 8);
  }
};

/// The image of one channel, grey, or three, red, green, blue, as a file; the same bytes for the
/// same image. Throws std::runtime_error.
[[nodiscard]] std::string encode(const PngImage& image);

/// The image in a file, a palette's colours as three channels. Throws std::runtime_error with what
/// is wrong with the file.
[[nodiscard]] PngImage decode_image(const std::string& file);

}  // namespace maquette::sim
