#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/rung_result.hpp"
#include "sim/sweep/table.hpp"

namespace maquette::sim {

/// One row per level: simulated times, picture, their errors and the reference they are held
/// against. Equal inputs give equal bytes: nothing in it comes from the host's clock.
[[nodiscard]] Table error_table(const std::vector<RungResult>& results);

/// One row per level: what it took on this host, which no two runs share, beside its error.
[[nodiscard]] Table host_time_table(const std::vector<RungResult>& results);

}  // namespace maquette::sim
