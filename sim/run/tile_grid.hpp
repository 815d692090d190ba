#pragma once

#include <cstddef>

#include "models/board/allotment.hpp"

namespace maquette::sim {

/// A zone cut into square tiles from its upper left corner on, numbered row by row; those at the
/// right and the bottom are cut by the zone.
struct TileGrid {
  static constexpr int k_tile_pixels = 16;  ///< along an edge

  models::PixelRectangle zone;

  [[nodiscard]] int columns() const { return (zone.width + k_tile_pixels - 1) / k_tile_pixels; }
  [[nodiscard]] int rows() const { return (zone.height + k_tile_pixels - 1) / k_tile_pixels; }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }

  /// The tile with a pixel of the zone.
  [[nodiscard]] std::size_t number_at(const models::PixelPosition& position) const;

  /// The pixels of a tile.
  [[nodiscard]] models::PixelRectangle rectangle(std::size_t tile) const;
};

}  // namespace maquette::sim
