#include "sim/database/surface_packing.hpp"

#include <algorithm>

#include "firmware/arithmetic/elementary.hpp"

namespace maquette::sim {

namespace {

constexpr double k_pi = firmware::elementary::k_pi;
constexpr double k_quarter_pi = k_pi / 4;
constexpr double k_ln_2 = firmware::elementary::k_ln_2;

/// Integral of exp(-parameter alpha^2) cos(alpha) over the hemisphere, by Simpson's rule as far as
/// the lobe reaches.
double gaussian_integral(double parameter) {
  constexpr int k_intervals = 2000;
  constexpr double k_lobe = 8;  // standard widths; exp(-64) is nothing
  const double end = std::min(k_pi / 2, k_lobe / firmware::square_root(parameter));
  const double step = end / k_intervals;
  double sum = 0;
  for (int i = 0; i <= k_intervals; ++i) {
    const double alpha = i * step;
    const double ring = firmware::sine(alpha) * firmware::cosine(alpha);
    const double value = firmware::exponential(-parameter * alpha * alpha) * ring;
    const bool is_end = i == 0 || i == k_intervals;
    sum += value * (is_end ? 1 : (i % 2 == 1 ? 4 : 2));
  }
  return 2 * k_pi * sum * step / 3;
}

firmware::FacetDistribution packed_distribution(FacetDistribution distribution) {
  switch (distribution) {
    case FacetDistribution::cosine_power:
      return firmware::FacetDistribution::cosine_power;
    case FacetDistribution::gaussian:
      return firmware::FacetDistribution::gaussian;
    case FacetDistribution::trowbridge_reitz:
      break;
  }
  return firmware::FacetDistribution::trowbridge_reitz;
}

}  // namespace

FacetShape facet_shape_of(FacetDistribution distribution, double half_angle) {
  const double cosine = firmware::cosine(half_angle);
  switch (distribution) {
    case FacetDistribution::cosine_power: {
      // cos(beta)^e = 1/2. The integral of cos^(e+1) over the hemisphere is 2 pi / (e + 2).
      const double exponent = -k_ln_2 / firmware::logarithm(cosine);
      return {exponent, (exponent + 2) / 8};
    }
    case FacetDistribution::gaussian: {
      const double parameter = k_ln_2 / (half_angle * half_angle);
      return {parameter, k_quarter_pi / gaussian_integral(parameter)};
    }
    case FacetDistribution::trowbridge_reitz:
      break;
  }
  // (c^2 / (cos^2 (c^2 - 1) + 1))^2 = 1/2. The integral of the square without c^4 is pi / c^2.
  const double cosine_squared = cosine * cosine;
  const double c_squared = (1 - cosine_squared) / (firmware::square_root(2.0) - cosine_squared);
  return {c_squared - 1, c_squared / 4};
}

firmware::Surface<double> packed_surface(const Surface& surface) {
  const FacetShape shape = facet_shape_of(surface.facets, surface.half_angle_deg * k_pi / 180);
  firmware::Surface<double> packed{};
  packed.diffuse = surface.diffuse;
  packed.specular = surface.specular;
  packed.metal = surface.metal;
  packed.transparent = surface.transparent;
  packed.absorbing = surface.transparent && surface.absorption != Color(0, 0, 0);
  packed.facets = packed_distribution(surface.facets);
  packed.index = surface.index;
  packed.extinction = surface.extinction;
  packed.facet_parameter = shape.parameter;
  packed.facet_scale = shape.scale;
  packed.absorption = surface.absorption;
  return packed;
}

}  // namespace maquette::sim
