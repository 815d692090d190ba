#pragma once

#include "models/machine/machine_statistics.hpp"
#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// What the boards did on the bus during the frame and how they waited for one another. Where
/// accesses overlap, on an ideal bus, each board has a bus to itself. Of a run that was
/// interrupted, waits and queue are those of the accesses granted so far. Throws std::logic_error
/// when a finished frame's waits do not sum to the boards' time in that state.
BusStatistics contention_statistics(const models::MachineStatistics& model,
                                    bool accesses_overlap = false);

}  // namespace maquette::sim
