#pragma once

#include "models/bus/duration.hpp"

namespace maquette::models {

/// A point of simulated time, as the span since the simulation's zero.
using Instant = Duration;

/// The smallest step of simulated time.
inline constexpr Duration k_tick{1};

/// The longest simulated time. An instant holds 106.75 days; what is left of them is longer than
/// any single step of a machine, so that no sum of an instant within this and a step overflows.
inline constexpr Duration k_longest_run = std::chrono::hours(24 * 100);

/// The instant that never comes.
inline constexpr Instant k_never = Instant::max();

}  // namespace maquette::models
