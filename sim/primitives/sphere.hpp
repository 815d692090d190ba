#pragma once

#include "firmware/primitives/sphere.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// A sphere or an ellipsoid, centred on the origin.
struct SphereShape {
  using Kind = firmware::sphere::Kind;

  Vector3 radii{1, 1, 1};
};

[[nodiscard]] LocalFrame frame_of(const SphereShape& shape);

}  // namespace maquette::sim
