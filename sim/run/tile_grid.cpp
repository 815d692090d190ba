#include "sim/run/tile_grid.hpp"

#include <algorithm>

namespace maquette::sim {

std::size_t TileGrid::number_at(const models::PixelPosition& position) const {
  const int column = (position.column - zone.column0) / k_tile_pixels;
  const int row = (position.row - zone.row0) / k_tile_pixels;
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
         static_cast<std::size_t>(column);
}

models::PixelRectangle TileGrid::rectangle(std::size_t tile) const {
  const auto per_row = static_cast<std::size_t>(columns());
  const int column = static_cast<int>(tile % per_row) * k_tile_pixels;
  const int row = static_cast<int>(tile / per_row) * k_tile_pixels;
  return {zone.column0 + column, zone.row0 + row, std::min(k_tile_pixels, zone.width - column),
          std::min(k_tile_pixels, zone.height - row)};
}

}  // namespace maquette::sim
