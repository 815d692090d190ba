#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The IdealArbiter.
[[nodiscard]] std::unique_ptr<BusEngine> make_ideal_engine(const VersaBusParameters& parameters,
                                                           const BusParts& parts);

inline constexpr BusLevel k_ideal_level{"ideal", "no contention at all", false, false,
                                        false,   make_ideal_engine};

}  // namespace maquette::models
