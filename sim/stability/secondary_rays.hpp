#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Rays spawned where others meet a solid (the idea of pbrt's test of reintersection): sizes from
/// 1e-4 to 1e4, origins from 1e-8 to 1e8, grazing angles down to 1e-6. Counts rays that leave and
/// meet the surface again, rays into the solid that start outside, and rays aimed at its inside
/// that pass through; of `trials` placements, eight rays each.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> secondary_ray_rows(const SolidFamily& family, int trials);

}  // namespace maquette::sim
