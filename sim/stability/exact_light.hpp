#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Pictures of random unions, intersections and differences of opaque solids, overlapping, touching
/// and with coincident faces, in turned frames: the pixels of single precision that have a light
/// which no exact ray within one pixel of them has.
[[nodiscard]] std::vector<StabilityRow> exact_light_rows(const std::vector<SolidFamily>& families,
                                                         int pictures);

}  // namespace maquette::sim
