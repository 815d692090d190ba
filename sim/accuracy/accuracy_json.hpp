#pragma once

#include <string>
#include <vector>

#include "sim/accuracy/ladder_result.hpp"

namespace maquette::sim {

/// The rows of error_table as JSON, by ladder, with the waiting time of every board. Equal inputs
/// give equal bytes.
[[nodiscard]] std::string error_json(const std::string& scene,
                                     const std::vector<LadderResult>& results);

/// The rows of host_time_table as JSON: what differs from run to run.
[[nodiscard]] std::string host_time_json(const std::vector<LadderResult>& results);

}  // namespace maquette::sim
