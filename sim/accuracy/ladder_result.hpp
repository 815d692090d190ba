#pragma once

#include <optional>
#include <vector>

#include "sim/accuracy/ladder.hpp"
#include "sim/accuracy/level_error.hpp"
#include "sim/accuracy/level_outcome.hpp"

namespace maquette::sim {

/// Processor times of one level on the host, which no two runs share.
struct HostTimes {
  double median_s = 0;
  double least_s = 0;
  double most_s = 0;
  int repeats = 0;
};

/// A level held against the reference of its ladder.
struct LevelResult {
  std::optional<SimulatedTimes> simulated;
  LevelError error;
  double magnitude = 0;  ///< of the error, as the ladder measures it
  bool is_on_simulated_front =
      false;  ///< of error against frame time, where the ladder trades them
  HostTimes host;
  bool is_on_host_front = false;  ///< of error against host time
};

/// A ladder with the results of its levels, in their order.
struct LadderResult {
  Ladder ladder;
  std::vector<LevelResult> levels;
};

/// Median and extremes of one time or more.
[[nodiscard]] HostTimes host_times_of(std::vector<double> times_s);

/// Holds every outcome (one or more per level, equal but for their host times) against the ladder's
/// reference. A ladder whose error is that of the frame time trades nothing for it.
[[nodiscard]] LadderResult result_of(const Ladder& ladder,
                                     const std::vector<std::vector<LevelOutcome>>& outcomes);

}  // namespace maquette::sim
