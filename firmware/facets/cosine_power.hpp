#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/facets/facet_distribution.hpp"

/// Phong's power of the cosine, as Blinn takes it: cos(alpha)^e with the exponent as parameter.
namespace maquette::firmware::cosine_power {

template <class Real>
[[gnu::noinline]] Real distribution(const Surface<Real>& surface, Real cosine) {
  return surface.facet_scale * power(cosine, surface.facet_parameter);
}

/// From cos(beta)^e = 1/2. The integral of cos^(e+1) over the hemisphere is 2 pi / (e + 2).
inline FacetShape shape(double half_angle) {
  const double exponent = -elementary::k_ln_2 / logarithm(cosine(half_angle));
  return {exponent, (exponent + 2) / 8};
}

/// What the table of distributions lists.
struct Kind {
  static constexpr FacetDistribution k_distribution{"cosine_power", "cosine power", shape};
  template <class Real>
  static constexpr auto k_value = distribution<Real>;
};

}  // namespace maquette::firmware::cosine_power
