#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Rays at solids whose axes differ by up to 1e6, of every primitive: crossings keep in/out parity,
/// and the points where they are seen are numbers. Of `trials` solids and twenty rays each.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> stretched_solid_rows(const SolidFamily& family, int trials);

/// Generatrices that touch the axis, with horizontal parts, closed ones, with sections that are a
/// point, a cusp or a line: the same laws.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> extreme_generatrix_rows(int trials);

}  // namespace maquette::sim
