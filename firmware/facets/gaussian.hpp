#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/facets/facet_distribution.hpp"

/// Torrance and Sparrow's Gaussian of the angle: exp(-(alpha/m)^2) with 1/m^2 as parameter.
namespace maquette::firmware::gaussian {

template <class Real>
[[gnu::noinline]] Real distribution(const Surface<Real>& surface, Real cosine) {
  const Real alpha = arc_cosine(cosine);
  return surface.facet_scale * exponential(-(alpha * alpha * surface.facet_parameter));
}

/// Integral of exp(-parameter alpha^2) cos(alpha) over the hemisphere, by Simpson's rule as far as
/// the lobe reaches.
inline double hemisphere_integral(double parameter) {
  constexpr int k_intervals = 2000;
  constexpr double k_lobe = 8;  // standard widths; exp(-64) is nothing
  const double end = smaller(elementary::k_pi / 2, k_lobe / square_root(parameter));
  const double step = end / k_intervals;
  double sum = 0;
  for (int i = 0; i <= k_intervals; ++i) {
    const double alpha = i * step;
    const double ring = sine(alpha) * cosine(alpha);
    const double value = exponential(-parameter * alpha * alpha) * ring;
    const bool is_end = i == 0 || i == k_intervals;
    sum += value * (is_end ? 1 : (i % 2 == 1 ? 4 : 2));
  }
  return 2 * elementary::k_pi * sum * step / 3;
}

inline FacetShape shape(double half_angle) {
  const double parameter = elementary::k_ln_2 / (half_angle * half_angle);
  return {parameter, elementary::k_pi / 4 / hemisphere_integral(parameter)};
}

/// What the table of distributions lists.
struct Kind {
  static constexpr FacetDistribution k_distribution{"gaussian", "Gaussian", shape};
  template <class Real>
  static constexpr auto k_value = distribution<Real>;
};

}  // namespace maquette::firmware::gaussian
