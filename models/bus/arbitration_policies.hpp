#pragma once

#include "models/bus/arbitration_priority.hpp"
#include "models/bus/arbitration_round_robin.hpp"

namespace maquette::models {

/// All that a description may choose from, in the order in which they are listed.
inline constexpr ArbitrationPolicy k_arbitration_policies[] = {k_priority, k_round_robin};

}  // namespace maquette::models
