#pragma once

#include <cmath>
#include <vector>

#include "firmware/facets.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware::trial {

/// All rows of the table of distributions.
inline std::vector<FacetKind> facet_kinds() {
  std::vector<FacetKind> kinds;
  for (int kind = 0; kind < k_facet_kind_count; ++kind) {
    kinds.push_back(static_cast<FacetKind>(kind));
  }
  return kinds;
}

/// Integral of D cos(alpha) over the hemisphere, by the midpoint rule over the root of the angle,
/// so that narrow lobes are seen as well.
inline double hemisphere_integral(const Surface<double>& surface) {
  constexpr int k_rings = 20000;
  double sum = 0;
  for (int ring = 0; ring < k_rings; ++ring) {
    const double root = (ring + 0.5) / k_rings;
    const double alpha = elementary::k_pi / 2 * root * root;
    sum += facet_distribution(surface, std::cos(alpha)) * std::cos(alpha) * std::sin(alpha) * root;
  }
  return 2 * elementary::k_pi * elementary::k_pi * sum / k_rings;
}

/// A specular dielectric whose facets fall to one half at an angle in radians.
inline Surface<double> facet_surface(FacetKind facets, double half_angle) {
  const FacetShape shape = distribution_of(facets).shape(half_angle);
  Surface<double> surface = matt_surface({0, 0, 0});
  surface.specular = 1;
  surface.facets = facets;
  surface.facet_parameter = shape.parameter;
  surface.facet_scale = shape.scale;
  return surface;
}

}  // namespace maquette::firmware::trial
