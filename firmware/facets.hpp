#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/database.hpp"

/// Micro-facets of a rough surface: how their normals scatter (Blinn 1977, the paper's reference
/// 13) and how they shade one another (Torrance and Sparrow 1967, reference 12). Functions that a
/// scene may not need are never inlined, so that the board can do without their code.
namespace maquette::firmware {

/// Blinn's three distributions of the facet normals, times the surface's scale that makes the
/// integral of D cos(alpha) over the hemisphere pi/4: then R_s = F D G / (pi cos theta cos phi)
/// reflects what a mirror would. `cosine` of the angle alpha between facet and surface normals.
template <class Real>
[[gnu::noinline]] Real cosine_power_distribution(const Surface<Real>& surface, Real cosine) {
  return surface.facet_scale * power(cosine, surface.facet_parameter);
}

template <class Real>
[[gnu::noinline]] Real gaussian_distribution(const Surface<Real>& surface, Real cosine) {
  const Real alpha = arc_cosine(cosine);
  return surface.facet_scale * exponential(-(alpha * alpha * surface.facet_parameter));
}

template <class Real>
[[gnu::noinline]] Real trowbridge_reitz_distribution(const Surface<Real>& surface, Real cosine) {
  const Real denominator = cosine * cosine * surface.facet_parameter + constant<Real>(1);
  return surface.facet_scale / (denominator * denominator);
}

template <class Real>
Real facet_distribution(const Surface<Real>& surface, Real cosine) {
  charge<Real>(Operation::branch, 2);
  charge<Real>(Operation::load, 2);
  charge<Real>(Operation::call);
  switch (surface.facets) {
    case FacetDistribution::cosine_power:
      return cosine_power_distribution(surface, cosine);
    case FacetDistribution::gaussian:
      return gaussian_distribution(surface, cosine);
    case FacetDistribution::trowbridge_reitz:
      break;
  }
  return trowbridge_reitz_distribution(surface, cosine);
}

/// The share of facets that is neither masked nor in shadow: G of Torrance and Sparrow, as Blinn
/// gives it. Cosines between the surface normal n, the half vector h, the view v, the light l.
template <class Real>
Real facet_attenuation(Real n_h, Real n_v, Real n_l, Real v_h) {
  const Real nearer = smaller(n_v, n_l);
  return smaller(constant<Real>(1), constant<Real>(2) * n_h * nearer / v_h);
}

}  // namespace maquette::firmware
