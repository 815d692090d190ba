#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The QueueingArbiter without a quantum: exact.
[[nodiscard]] std::unique_ptr<BusArbiter> make_transaction_arbiter(
    const VersaBusParameters& parameters, BusAccount& account);

inline constexpr BusLevel k_transaction_level{"transaction",
                                              "every request arbitrated at its instant", false,
                                              true, make_transaction_arbiter};

}  // namespace maquette::models
