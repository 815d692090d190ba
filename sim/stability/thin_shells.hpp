#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// A convex solid without a slightly smaller copy of itself: shells from 1e-2 to 1e-6 of the size.
/// A ray through the middle crosses two walls; none may be lost that is thicker than faces that
/// fall together. Of `trials` shells for each thickness.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> thin_shell_rows(const std::vector<SolidFamily>& families,
                                                        int trials);

}  // namespace maquette::sim
