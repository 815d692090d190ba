#pragma once

#include <vector>

#include "sim/stability/machine_case.hpp"

namespace maquette::sim {

/// One board whose clocks and accesses last from 1 ns to 1 s, in every combination; clocks that are
/// no whole numbers of picoseconds; frames of days, up to the longest simulated time. Their frame
/// times are known in closed form.
[[nodiscard]] std::vector<MachineCase> stiff_machines();

/// Frames beyond it, which say so.
[[nodiscard]] std::vector<MachineCase> endless_machines();

}  // namespace maquette::sim
