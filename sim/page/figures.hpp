#pragma once

#include <string>

#include "models/bus/duration.hpp"

namespace maquette::sim {

/// A part of a whole, 0 of nothing.
[[nodiscard]] double share_of(double part, double whole);

/// "35.33 %".
[[nodiscard]] std::string percent(double share, int decimals = 2);

/// Seconds with four decimals, as the summary has them.
[[nodiscard]] std::string four_decimals(models::Duration time);

}  // namespace maquette::sim
