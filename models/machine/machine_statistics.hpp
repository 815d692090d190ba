#pragma once

#include <vector>

#include "models/board/board_statistics.hpp"
#include "models/bus/bus_statistics.hpp"
#include "models/machine/host_statistics.hpp"
#include "models/unit/unit_statistics.hpp"

namespace maquette::models {

/// Figures of a whole run, exact in ticks.
struct MachineStatistics {
  bool has_finished = false;              ///< all boards are done
  Duration load_time{};                   ///< from instant 0: the host writes the images
  Duration frame_time{};                  ///< from the boards' start to the last one's end
  std::vector<BoardStatistics> boards;    ///< each one's states sum to frame_time
  std::vector<UnitKindStatistics> units;  ///< of the kinds that there are; states likewise
  BusStatistics bus;  ///< masters: boards, units, then host; all backplanes as one
  int backplanes = 1;
  HostStatistics host;
};

}  // namespace maquette::models
