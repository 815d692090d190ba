#pragma once

#include "firmware/vector.hpp"

/// Share of unpolarised light that a smooth surface reflects, by Fresnel's equations (Cook and
/// Torrance 1982, reference 11 of the paper).
namespace maquette::firmware {

/// Reflected share at the border of two dielectrics and what refraction needs of it.
template <class Real>
struct DielectricBorder {
  Real reflected;           ///< F, 1 where reflection is total
  Real transmitted_cosine;  ///< n * cosine of the refraction angle; 0 where reflection is total
};

/// `cosine` of the angle of incidence, 0..1; `index` of the far medium relative to the near one.
/// With g^2 = n^2 + c^2 - 1: F = (g-c)^2 / (2 (g+c)^2) * (1 + (c(g+c)-1)^2 / (c(g-c)+1)^2).
template <class Real>
DielectricBorder<Real> dielectric_border(Real cosine, Real index) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Real g_squared = index * index + (cosine * cosine - one);
  if (!(g_squared > zero)) {
    return {one, zero};
  }
  const Real g = square_root(g_squared);
  const Real sum = g + cosine;
  const Real difference = g - cosine;
  const Real first = difference / sum;
  const Real second = (cosine * sum - one) / (cosine * difference + one);
  return {constant<Real>(0.5) * first * first * (one + second * second), g};
}

/// Reflected share of a conductor of index n and extinction k in one colour, exact for unpolarised
/// light; `cosine` of the angle of incidence, 0..1.
template <class Real>
[[gnu::noinline]] Real conductor_reflection(Real cosine, Real index, Real extinction) {
  const Real two = constant<Real>(2);
  const Real cosine_squared = cosine * cosine;
  const Real sine_squared = constant<Real>(1) - cosine_squared;
  const Real n_squared = index * index;
  const Real k_squared = extinction * extinction;
  const Real t = n_squared - k_squared - sine_squared;
  const Real a2_plus_b2 = square_root(t * t + constant<Real>(4) * n_squared * k_squared);
  const Real a = square_root(larger((a2_plus_b2 + t) * constant<Real>(0.5), constant<Real>(0)));
  const Real cross_term = two * a * cosine;
  const Real sum = a2_plus_b2 + cosine_squared;
  const Real perpendicular = (sum - cross_term) / (sum + cross_term);
  const Real parallel_term = cross_term * sine_squared;
  const Real parallel_sum = cosine_squared * a2_plus_b2 + sine_squared * sine_squared;
  const Real ratio = (parallel_sum - parallel_term) / (parallel_sum + parallel_term);
  return constant<Real>(0.5) * perpendicular * (constant<Real>(1) + ratio);
}

}  // namespace maquette::firmware
