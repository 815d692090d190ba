#pragma once

#include <cstdint>
#include <vector>

#include "models/bus/duration.hpp"
#include "models/display/picture.hpp"
#include "sim/machine/machine.hpp"
#include "sim/run/tile_grid.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// How long a board computes on the pixels of each tile of the useful zone, without preprocessing
/// and without the bus.
struct TileTimes {
  TileGrid grid;
  std::vector<models::Duration> times;  ///< by tile; zero for one that was left out

  [[nodiscard]] models::Duration sum() const;

  /// Of the tiles that were not left out.
  [[nodiscard]] std::int64_t pixels() const;
};

/// The tiles of a sample of about one in `share`, as TileGrid::step has it, by the work that the
/// native firmware counts.
[[nodiscard]] TileTimes counted_tile_times(const Scene& scene, const Machine& machine, int share);

/// The same by the board's program, executed (execute_pixels), which writes its pixels into
/// `picture`. Ends early when an interruption is requested.
[[nodiscard]] TileTimes executed_tile_times(const Scene& scene, const Machine& machine, int share,
                                            models::Picture& picture);

}  // namespace maquette::sim
