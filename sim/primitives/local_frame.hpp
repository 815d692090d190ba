#pragma once

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "firmware/database.hpp"

namespace maquette::sim {

using Vector3 = glm::dvec3;
using Placement = glm::dmat4x3;  ///< affine: columns are the images of x, y, z and the origin

/// A primitive of a description in the firmware's terms: which canonical solid, its
/// parameters if it has any, and the frame that makes the described solid of the canonical one.
struct LocalFrame {
  firmware::PrimitiveKind kind;
  std::vector<double> parameters;
  Placement to_object;
  /// Of a kind with a conversion: what boards convert to the parameters.
  std::vector<double> given = {};
};

/// Scales along the axes and moves along z.
inline Placement scaled_and_raised(const Vector3& scale, double height) {
  return {scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z, 0, 0, height};
}

}  // namespace maquette::sim
