#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// Rays through random trees of solids, fifty for each of `trees`: their crossings must be in
/// order, each into another medium, the last into the void; and a point that is not near a surface
/// must be inside on every line through it, or on none.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> ray_parity_rows(const std::vector<SolidFamily>& families,
                                                        int trees);

}  // namespace maquette::sim
