#pragma once

#include <optional>

#include "models/machine/machine_statistics.hpp"
#include "sim/report/unit_statistics.hpp"

namespace maquette::sim {

/// What the function units of a machine did; nothing of one that has none. The bus was busy for a
/// share of the frame. Throws std::logic_error when states do not sum to the frame time.
std::optional<UnitsStatistics> units_statistics(const models::MachineStatistics& model,
                                                double bus_utilisation);

}  // namespace maquette::sim
