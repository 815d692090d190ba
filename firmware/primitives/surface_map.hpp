#pragma once

#include <cstdint>
#include <type_traits>

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/vector.hpp"

/// Parameters of a primitive's own surface, by which pictures are laid on it.
namespace maquette::firmware {

/// A place on a surface; u and v from 0 to 1.
template <class Real>
struct SurfacePlace {
  Real u;
  Real v;
};

/// The place of a point of a face, given in the primitive's local frame.
template <class Real>
using SurfaceMap = SurfacePlace<Real> (*)(const Vector<Real>& point, std::uint8_t face,
                                          const Real* parameters);

/// Largest number below 1 that every format holds.
inline constexpr double k_nearly_one = 1 - 1.0 / (1 << 23);

/// Put between 0 and what is nearly 1, so that a place counted in texels is one of them.
template <class Real>
Real within_unit(Real value) {
  return larger(constant<Real>(0), smaller(value, constant<Real>(k_nearly_one)));
}

/// A coordinate from -1 to 1 as a parameter.
template <class Real>
[[gnu::noinline]] Real from_edges(Real coordinate) {
  return within_unit(coordinate * constant<Real>(0.5) + constant<Real>(0.5));
}

/// The share of a turn from the x axis by way of the y axis to a direction.
template <class Real>
Real turn_of(Real x, Real y) {
  const Real zero = constant<Real>(0);
  const Real radius = square_root(x * x + y * y);
  if (!(radius > zero)) {
    return zero;
  }
  const Real cosine = smaller(constant<Real>(1), absolute(x) / radius);
  const Real quarter = arc_cosine(cosine) * constant<Real>(0.5 / elementary::k_pi);
  const Real half = x < zero ? constant<Real>(0.5) - quarter : quarter;
  return within_unit(y < zero ? constant<Real>(1) - half : half);
}

}  // namespace maquette::firmware
