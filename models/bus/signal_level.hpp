#pragma once

#include "models/bus/bus_level.hpp"

namespace maquette::models {

/// The SignalEngine: the reference of the others.
[[nodiscard]] std::unique_ptr<BusEngine> make_signal_engine(const VersaBusParameters& parameters,
                                                            const BusParts& parts);

inline constexpr BusLevel k_signal_level{
    "signal", "every line of every handshake", false, true, true, make_signal_engine};

}  // namespace maquette::models
