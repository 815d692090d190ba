#pragma once

#include "models/bus/duration.hpp"

namespace maquette::models {

/// A point of simulated time, as the span since the simulation's zero.
using Instant = Duration;

/// The smallest step of simulated time.
inline constexpr Duration k_tick{1};

/// The instant that never comes.
inline constexpr Instant k_never = Instant::max();

}  // namespace maquette::models
