#include "sim/database/surface_packing.hpp"

#include <cmath>

#include "firmware/facets.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

constexpr double k_pi = firmware::elementary::k_pi;
constexpr FacetDistribution k_distributions[] = {FacetDistribution::cosine_power,
                                                 FacetDistribution::gaussian,
                                                 FacetDistribution::trowbridge_reitz};

firmware::Surface<double> surface_of(FacetDistribution distribution, double half_angle_deg) {
  Surface surface;
  surface.specular = 1;
  surface.facets = distribution;
  surface.half_angle_deg = half_angle_deg;
  return packed_surface(surface);
}

/// Integral of D cos(alpha) over the hemisphere, by the midpoint rule.
double hemisphere_integral(const firmware::Surface<double>& surface) {
  constexpr int k_rings = 200000;
  const double step = k_pi / 2 / k_rings;
  double sum = 0;
  for (int ring = 0; ring < k_rings; ++ring) {
    const double alpha = (ring + 0.5) * step;
    sum +=
        firmware::facet_distribution(surface, std::cos(alpha)) * std::cos(alpha) * std::sin(alpha);
  }
  return 2 * k_pi * sum * step;
}

TEST_CASE("Distributions of facets are scaled to what a mirror reflects, whatever the half angle") {
  for (const FacetDistribution distribution : k_distributions) {
    for (const double half_angle_deg : {0.5, 2.0, 10.0, 30.0, 60.0, 85.0}) {
      CAPTURE(static_cast<int>(distribution), half_angle_deg);
      CHECK(hemisphere_integral(surface_of(distribution, half_angle_deg)) ==
            Approx(k_pi / 4).epsilon(1e-4));
    }
  }
}

TEST_CASE("Distributions fall to one half of their peak at the half angle") {
  for (const FacetDistribution distribution : k_distributions) {
    for (const double half_angle_deg : {0.5, 2.0, 10.0, 30.0, 60.0, 85.0}) {
      const firmware::Surface<double> surface = surface_of(distribution, half_angle_deg);
      const double half =
          firmware::facet_distribution(surface, std::cos(half_angle_deg * k_pi / 180));
      CAPTURE(static_cast<int>(distribution), half_angle_deg);
      CHECK(half / firmware::facet_distribution(surface, 1.0) == Approx(0.5).epsilon(1e-9));
    }
  }
}

TEST_CASE("Only transparent matter absorbs") {
  Surface surface;
  surface.absorption = {1, 0, 0};
  CHECK_FALSE(packed_surface(surface).absorbing);
  surface.transparent = true;
  CHECK(packed_surface(surface).absorbing);
  surface.absorption = {0, 0, 0};
  CHECK_FALSE(packed_surface(surface).absorbing);
}

}  // namespace
}  // namespace maquette::sim
