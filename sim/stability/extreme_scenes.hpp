#pragma once

#include <vector>

#include "sim/stability/shipped_scenes.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Every scene driven to an extreme in one respect after the other: flat and needle placements,
/// optics, roughness, depth of the ray tree, where the eye and the light are, frames. Counts pixels
/// whose luminance is negative, infinite or not a number.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> extreme_scene_rows(const std::vector<ShippedScene>& scenes);

}  // namespace maquette::sim
