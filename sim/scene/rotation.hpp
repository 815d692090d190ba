#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace maquette::sim {

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in degrees, exact at multiples of 90 degrees and independent of the
/// C library.
[[nodiscard]] SineCosine sine_cosine_deg(double degrees);

/// Turns by the angle around the axis, which has any length but 0 (Rodrigues' formula;
/// right-handed).
[[nodiscard]] glm::dmat3 rotation(const glm::dvec3& axis, double degrees);

}  // namespace maquette::sim
