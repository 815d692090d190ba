#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The QueueingArbiter whose masters run ahead of one another for the bus's quantum.
[[nodiscard]] std::unique_ptr<BusEngine> make_decoupled_engine(const VersaBusParameters& parameters,
                                                               const BusParts& parts);

inline constexpr BusLevel k_decoupled_level{
    "decoupled",          "boards that run ahead of one another for a quantum", true, true, false,
    make_decoupled_engine};

}  // namespace maquette::models
