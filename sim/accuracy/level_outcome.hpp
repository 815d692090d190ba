#pragma once

#include <optional>
#include <vector>

#include "models/bus/duration.hpp"
#include "models/display/picture.hpp"
#include "sim/accuracy/tile_times.hpp"

namespace maquette::sim {

/// What the machine did, of a level that simulates it.
struct SimulatedTimes {
  models::Duration frame{};
  std::vector<models::Duration> waits;  ///< for grants of the bus, by board; none: not known
  double processor_clocks = 0;          ///< of all boards during the frame
};

/// What comes of computing a scene at one level. All but the host time is determined by the input.
struct LevelOutcome {
  std::optional<SimulatedTimes> simulated;
  models::Picture picture;
  double host_time_s = 0;  ///< processor time
  std::optional<TileTimes> tiles;
};

}  // namespace maquette::sim
