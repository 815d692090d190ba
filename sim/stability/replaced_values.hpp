#pragma once

#include <vector>

#include "sim/stability/shipped_scenes.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Every number of a scene replaced, one at a time, by values at and beyond the limits. Counts
/// values that are not finite and are not refused, and what finite values that are allowed do to
/// the picture; of the numbers of a scene each `stride`th. And several together, in `turns` scenes.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> replaced_value_rows(const std::vector<ShippedScene>& scenes,
                                                            int turns, int stride);

}  // namespace maquette::sim
