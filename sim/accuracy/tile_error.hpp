#pragma once

#include <optional>
#include <vector>

#include "sim/accuracy/tile_times.hpp"

namespace maquette::sim {

/// How far the time of each tile is from the reference's, relative to that; of the tiles that both
/// have timed. The quantiles are those of the sizes, without sign.
struct TileError {
  TileGrid grid;
  std::vector<std::optional<double>> relative;  ///< with its sign, by tile
  double median = 0;
  double most_of_95 = 0;  ///< not exceeded by 95 % of the tiles
  double worst = 0;
};

/// The errors of a level's tiles, for a reference of the same zone.
[[nodiscard]] TileError tile_error(const TileTimes& tiles, const TileTimes& reference);

}  // namespace maquette::sim
