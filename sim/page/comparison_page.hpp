#pragma once

#include <string>
#include <vector>

#include "sim/page/run_results.hpp"

namespace maquette::sim {

/// The page of several runs side by side: what differs from the first, marked, and where pictures
/// differ a picture of the difference. There are two runs or more.
[[nodiscard]] std::string comparison_page(const std::vector<RunResults>& runs);

}  // namespace maquette::sim
