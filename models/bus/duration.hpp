#pragma once

#include <chrono>
#include <cstdint>

namespace maquette::models {

/// A span of simulated time in whole picoseconds, the kernel's tick. Descriptions use it so that
/// they need not see SystemC.
using Duration = std::chrono::duration<std::int64_t, std::pico>;

/// A count of clocks of a named component; fractions are allowed in cost tables only.
using Clocks = std::int64_t;

}  // namespace maquette::models
