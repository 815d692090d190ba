#pragma once

#include "firmware/database.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Shape of a facet distribution whose value falls to one half at an angle (Blinn 1977), and the
/// scale that makes the integral of D cos(alpha) over the hemisphere pi/4.
struct FacetShape {
  double parameter;  ///< exponent; 1/m^2; c^2 - 1
  double scale;
};

/// `half_angle` in radians, above 0 and below pi/2.
FacetShape facet_shape_of(FacetDistribution distribution, double half_angle);

/// A surface in the firmware's form, in double precision.
firmware::Surface<double> packed_surface(const Surface& surface);

}  // namespace maquette::sim
