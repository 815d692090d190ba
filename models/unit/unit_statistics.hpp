#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/board/board_statistics.hpp"
#include "models/bus/checked_sum.hpp"
#include "models/unit/unit_parameters.hpp"

namespace maquette::models {

/// How long errands waited for something: all together, and the longest.
struct ErrandWait {
  Duration sum{};
  Duration longest{};

  void add(Duration wait) {
    sum = checked_sum(sum, wait);
    longest = wait > longest ? wait : longest;
  }
};

/// What one unit did. Its states, as of a board, sum to the frame time: compute is service,
/// wait_unit that what it has served waits for a place with the next kind.
struct FunctionUnitStatistics {
  std::string name;
  BoardStatistics states;
  std::int64_t errands = 0;  ///< served, or in service
  ErrandWait queued;         ///< from the arrival of an errand to its service
  int longest_queue = 0;     ///< errands that waited together, those in service not among them
};

/// The units of one kind.
struct UnitKindStatistics {
  UnitKind kind{};
  std::vector<FunctionUnitStatistics> units;
  std::int64_t places = 0;            ///< asked for
  ErrandWait waited;                  ///< from asking for a place to having it
  std::vector<Duration> board_waits;  ///< of each board: nothing to do until one of this kind has
};

}  // namespace maquette::models
