#pragma once

#include <cstdint>
#include <vector>

#include "firmware/arithmetic/extent_use.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// How many leaves each node holds, itself included.
std::vector<std::uint32_t> leaves_below(const ObjectTree& tree);

/// Leaves extents out where the number type allows it. The useful zone stays that of the root.
template <class Real>
void choose_extents(Extents extents, firmware::ExtentUse<Real>& use) {
  if constexpr (firmware::ExtentUse<Real>::is_chosen) {
    const bool all = extents == Extents::all;
    use.tests_rectangles = all || extents == Extents::rectangles;
    use.tests_boxes = all || extents == Extents::boxes;
    use.tests_spheres = all || extents == Extents::spheres;
  }
}

}  // namespace maquette::sim
