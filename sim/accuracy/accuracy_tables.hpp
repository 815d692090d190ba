#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/ladder_result.hpp"
#include "sim/report/table.hpp"

namespace maquette::sim {

/// One row per level: simulated times, picture, their errors and the reference they are held
/// against. Equal inputs give equal bytes: nothing in it comes from the host's clock.
[[nodiscard]] Table error_table(const std::vector<LadderResult>& results);

/// One row per level: what it took on this host, which no two runs share, beside its error.
[[nodiscard]] Table host_time_table(const std::vector<LadderResult>& results);

}  // namespace maquette::sim
