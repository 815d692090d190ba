#pragma once

#include <vector>

#include "firmware/database.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A primitive of a description in the firmware's terms: which canonical solid, its
/// parameters if it has any, and the frame that makes the described solid of the canonical one.
struct LocalFrame {
  firmware::PrimitiveKind kind;
  std::vector<double> parameters;
  Placement to_object;
};

/// The firmware's form of a primitive object; its own placement is not in it. A cone with equal
/// radii is a cylinder.
LocalFrame local_frame_of(const Object& primitive);

/// The inverse of an affine placement that is not singular.
Placement inverse_of(const Placement& placement);

}  // namespace maquette::sim
