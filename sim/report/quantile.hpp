#pragma once

#include <vector>

namespace maquette::sim {

/// The value below which a share of the sorted, non-empty values lies, interpolated linearly
/// between neighbours (Hyndman and Fan 1996, type 7). `share` is 0 to 1.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

}  // namespace maquette::sim
