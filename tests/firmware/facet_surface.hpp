#pragma once

#include <cmath>

#include "firmware/facets.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware::trial {

/// Integral of D cos(alpha) over the hemisphere, by the midpoint rule.
inline double hemisphere_integral(const Surface<double>& surface) {
  constexpr int k_rings = 20000;
  const double step = elementary::k_pi / 2 / k_rings;
  double sum = 0;
  for (int ring = 0; ring < k_rings; ++ring) {
    const double alpha = (ring + 0.5) * step;
    sum += facet_distribution(surface, std::cos(alpha)) * std::cos(alpha) * std::sin(alpha);
  }
  return 2 * elementary::k_pi * sum * step;
}

/// A specular dielectric whose facets fall to one half at an angle (Blinn 1977). The shape follows
/// from that condition, the scale from the integral that it must have, pi/4.
inline Surface<double> facet_surface(FacetDistribution distribution, double half_angle) {
  const double cosine = std::cos(half_angle);
  const double root_two = std::sqrt(2.0);
  Surface<double> surface = matt_surface({0, 0, 0});
  surface.specular = 1;
  surface.facets = distribution;
  switch (distribution) {
    case FacetDistribution::cosine_power:
      surface.facet_parameter = std::log(0.5) / std::log(cosine);
      break;
    case FacetDistribution::gaussian:
      surface.facet_parameter = std::log(2.0) / (half_angle * half_angle);
      break;
    case FacetDistribution::trowbridge_reitz:
      // (1 + p) / (1 + p cos^2) = 1 / sqrt 2 with p = c^2 - 1.
      surface.facet_parameter = (1 / root_two - 1) / (1 - cosine * cosine / root_two);
      break;
  }
  surface.facet_scale = 1;
  surface.facet_scale = elementary::k_pi / 4 / hemisphere_integral(surface);
  return surface;
}

}  // namespace maquette::firmware::trial
