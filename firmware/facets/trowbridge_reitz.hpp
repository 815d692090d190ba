#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/facets/facet_distribution.hpp"

/// Trowbridge and Reitz's ellipsoids of revolution: (c^2 / (cos^2(alpha) (c^2 - 1) + 1))^2 with
/// c^2 - 1 as parameter.
namespace maquette::firmware::trowbridge_reitz {

template <class Real>
[[gnu::noinline]] Real distribution(const Surface<Real>& surface, Real cosine) {
  const Real denominator = cosine * cosine * surface.facet_parameter + constant<Real>(1);
  return surface.facet_scale / (denominator * denominator);
}

/// From a value of 1/2 at the half angle. The integral of the square without c^4 is pi / c^2.
inline FacetShape shape(double half_angle) {
  const double cosine_of_half = cosine(half_angle);
  const double cosine_squared = cosine_of_half * cosine_of_half;
  const double c_squared = (1 - cosine_squared) / (square_root(2.0) - cosine_squared);
  return {c_squared - 1, c_squared / 4};
}

/// What the table of distributions lists.
struct Kind {
  static constexpr FacetDistribution k_distribution{"trowbridge_reitz", "Trowbridge-Reitz", shape};
  template <class Real>
  static constexpr auto k_value = distribution<Real>;
};

}  // namespace maquette::firmware::trowbridge_reitz
