#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/ladder_result.hpp"

namespace maquette::sim {

/// Errors and host times of all levels in one table, for the eye.
[[nodiscard]] std::string accuracy_report(const std::vector<LadderResult>& results);

}  // namespace maquette::sim
