#pragma once

#include <cstdint>

#include "models/board/interlace.hpp"
#include "models/board/pixel_rectangle.hpp"

namespace maquette::models {

/// Where the boards of an interlace keep the pixels that they own: each in its RAM from the same
/// address on, row by row of its own, four bytes a pixel as in a frame memory on the bus.
struct PixelStore {
  static constexpr std::uint64_t k_pixel_bytes = 4;

  Interlace interlace;
  int width;  ///< of the whole picture
  int height;
  std::uint64_t address = 0;

  /// What the board with the most pixels needs.
  [[nodiscard]] std::uint64_t bytes() const {
    const int rows = (height - 1) / interlace.lines + 1;
    return k_pixel_bytes * static_cast<std::uint64_t>(columns()) * static_cast<std::uint64_t>(rows);
  }

  /// The address of a pixel in the RAM of its board.
  [[nodiscard]] std::uint64_t address_of(const PixelPosition& position) const {
    const auto row = static_cast<std::uint64_t>(position.row / interlace.lines);
    const auto column = static_cast<std::uint64_t>(position.column / interlace.columns);
    return address + k_pixel_bytes * (row * static_cast<std::uint64_t>(columns()) + column);
  }

 private:
  [[nodiscard]] int columns() const { return (width - 1) / interlace.columns + 1; }
};

}  // namespace maquette::models
