#pragma once

#include <vector>

#include "models/bus/duration.hpp"
#include "models/display/picture.hpp"
#include "sim/machine/machine.hpp"
#include "sim/run/tile_grid.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// How long a board computes on the pixels of each tile of the useful zone, or on those of a
/// sample, without preprocessing and without the bus.
struct TileTimes {
  TileGrid grid;
  std::vector<models::Duration> times;  ///< by tile; zero for one without pixels of the sample

  [[nodiscard]] models::Duration sum() const;
};

/// The times of a sample of one in about `share` pixels (pixel_sample), by the work that the native
/// firmware counts.
[[nodiscard]] TileTimes counted_tile_times(const Scene& scene, const Machine& machine, int share);

/// The same by the board's program, executed (execute_pixels), which writes its pixels into
/// `picture`. Ends early when an interruption is requested.
[[nodiscard]] TileTimes executed_tile_times(const Scene& scene, const Machine& machine, int share,
                                            models::Picture& picture);

}  // namespace maquette::sim
