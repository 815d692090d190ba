#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"

namespace maquette::sim {

/// A kind of random scenes in which bodies meet: lit and opaque, of matt surfaces of three colours,
/// seen from somewhere.
struct CreaseScenes {
  const char* name;
  Scene (*make)(trial::Random& random, const std::vector<SolidFamily>& families);
};

[[nodiscard]] const std::vector<CreaseScenes>& crease_scenes();

}  // namespace maquette::sim
