#pragma once

#include <vector>

#include "sim/stability/shipped_scenes.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Numbers of a scene replaced, one at a time, by values at and beyond the limits. Counts
/// values that are not finite and are not refused, and what finite values that are allowed do to
/// the picture; of about forty numbers of a scene one in `stride`. And several together, in
/// `trials` scenes.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> replaced_value_rows(const std::vector<ShippedScene>& scenes,
                                                            int trials, int stride);

}  // namespace maquette::sim
