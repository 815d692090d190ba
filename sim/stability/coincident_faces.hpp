#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Solids without themselves, whose faces fall together but for rounding: their placements rounded
/// otherwise, and round solids turned about their axes. Counts rays that still see a skin, of
/// `trials` bodies and fifty rays each. A ray that grazes a face or an edge may see it, and is
/// counted apart.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> coincident_solid_rows(const SolidFamily& family,
                                                              int trials);

/// Two boxes with a common face, turned and placed at random: united they have no face there, they
/// have nothing in common, and one without the other is whole.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> touching_box_rows(int trials);

}  // namespace maquette::sim
