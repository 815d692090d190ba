#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The QueueingArbiter without a quantum: exact.
[[nodiscard]] std::unique_ptr<BusEngine> make_transaction_engine(
    const VersaBusParameters& parameters, const BusParts& parts);

inline constexpr BusLevel k_transaction_level{
    "transaction",          "every request arbitrated at its instant", false, true, false,
    make_transaction_engine};

}  // namespace maquette::models
