#pragma once

#include "firmware/database.hpp"

namespace maquette::firmware {

/// What a surface has of its distribution. The scale makes the integral of D cos(alpha) over the
/// hemisphere pi/4: then R_s = F D G / (pi cos theta cos phi) reflects what a mirror would.
struct FacetShape {
  double parameter;
  double scale;
};

/// What is known of a distribution of the facets' normals besides its values.
struct FacetDistribution {
  const char* name;   ///< in scenes, and its namespace here
  const char* title;  ///< in reports
  /// The shape whose values fall to one half at an angle (Blinn 1977), in radians, above 0 and
  /// below pi/2. The host makes it: a board gets it with the surface.
  FacetShape (*shape)(double half_angle);
};

}  // namespace maquette::firmware
