#pragma once

#include <vector>

#include "sim/machine/machine.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/run/simulation.hpp"

namespace maquette::sim {

/// The boards given to --dump-ram. Throws DescriptionError for one that the machine has not, and
/// when boards do not execute their program, since then nothing happens in their RAM.
std::vector<int> checked_boards(const std::vector<int>& boards, bool executed,
                                const Machine& machine);

/// Adds ram-BOARD.bin of each board and ram.map, if there are any.
void add_ram_files(const std::vector<int>& boards, const SimulationResult& result,
                   std::vector<NamedContent>& files);

}  // namespace maquette::sim
