#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The IdealArbiter.
[[nodiscard]] std::unique_ptr<BusArbiter> make_ideal_arbiter(const VersaBusParameters& parameters,
                                                             BusAccount& account);

inline constexpr BusLevel k_ideal_level{"ideal", "no contention at all", false, false,
                                        make_ideal_arbiter};

}  // namespace maquette::models
