#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace maquette::models {

/// A picture in row-major order from the top left, 0xRRGGBB per pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;

  [[nodiscard]] std::uint32_t at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

}  // namespace maquette::models
