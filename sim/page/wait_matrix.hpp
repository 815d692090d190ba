#pragma once

#include "sim/page/html.hpp"
#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// Who waited for whom: a matrix of all masters, or of a large machine the pairs that waited
/// longest.
[[nodiscard]] Html wait_matrix(const BusStatistics& bus);

}  // namespace maquette::sim
