#pragma once

#include <vector>

#include "sim/stability/machine_case.hpp"

namespace maquette::sim {

/// One to 256 boards, all on one level of the bus, which it saturates or which do nothing but
/// write; under each policy of arbitration. The closed forms are those of the saturated bus, and of
/// the board that fixed priority serves last.
[[nodiscard]] std::vector<MachineCase> crowded_machines();

/// A video reader that takes every slot, behind which boards would starve for ever, and one that
/// leaves just enough.
[[nodiscard]] std::vector<MachineCase> watched_machines();

/// Boards that starve while others try to claim units.
[[nodiscard]] std::vector<MachineCase> starving_machines();

}  // namespace maquette::sim
