#pragma once

#include "models/bus/decoupled_level.hpp"
#include "models/bus/ideal_level.hpp"
#include "models/bus/signal_level.hpp"
#include "models/bus/transaction_level.hpp"

namespace maquette::models {

/// All that a description or a command line may choose from, from the most exact to the least.
inline constexpr BusLevel k_bus_levels[] = {k_signal_level, k_transaction_level, k_decoupled_level,
                                            k_ideal_level};

}  // namespace maquette::models
