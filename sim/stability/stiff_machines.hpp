#pragma once

#include <vector>

#include "sim/stability/machine_case.hpp"

namespace maquette::sim {

/// One board whose clocks and accesses last from 1 ns to 1 s, in every combination; clocks that are
/// no whole numbers of picoseconds; frames of days, up to the longest simulated time and beyond.
/// Their frame times are known in closed form.
[[nodiscard]] std::vector<MachineCase> stiff_machines();

}  // namespace maquette::sim
