#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/facets/facet_table.hpp"

/// Micro-facets of a rough surface: how their normals scatter (Blinn 1977, the paper's reference
/// 13) and how they shade one another (Torrance and Sparrow 1967, reference 12). Functions that a
/// scene may not need are never inlined, so that the board can do without their code.
namespace maquette::firmware {

template <class Real, class Last>
Real facet_value(KindList<Last> /*kinds*/, const Surface<Real>& surface, Real cosine) {
  return Last::template k_value<Real>(surface, cosine);
}

/// The value of the distribution that a surface has, which is one of a list. Two rows share a
/// switch, of which a compiler for the 68000 makes shorter code than of two questions; the last row
/// of all needs none.
template <class Real, class First, class Second, class... Others>
Real facet_value(KindList<First, Second, Others...> /*kinds*/, const Surface<Real>& surface,
                 Real cosine) {
  switch (static_cast<int>(surface.facets)) {
    case static_cast<int>(facet_kind_of<First>):
      return First::template k_value<Real>(surface, cosine);
    case static_cast<int>(facet_kind_of<Second>):
      return Second::template k_value<Real>(surface, cosine);
    default:
      if constexpr (sizeof...(Others) > 0) {
        return facet_value(KindList<Others...>{}, surface, cosine);
      } else {
        return Second::template k_value<Real>(surface, cosine);
      }
  }
}

/// D of a surface, times its scale. `cosine` of the angle alpha between facet and surface normals.
/// Finding the row is charged alike however many there are: no scene pays for a distribution that
/// it does not need.
template <class Real>
Real facet_distribution(const Surface<Real>& surface, Real cosine) {
  charge<Real>(Operation::facets);
  charge<Real>(Operation::load, 2);
  return facet_value(FacetKinds{}, surface, cosine);
}

/// The share of facets that is neither masked nor in shadow: G of Torrance and Sparrow, as Blinn
/// gives it. Cosines between the surface normal n, the half vector h, the view v, the light l; l_h
/// is v_h where the light is reflected.
template <class Real>
Real facet_attenuation(Real n_h, Real n_v, Real n_l, Real v_h, Real l_h) {
  const Real nearer = smaller(n_v / v_h, n_l / l_h);
  return smaller(constant<Real>(1), constant<Real>(2) * n_h * nearer);
}

/// The same for reflected light.
template <class Real>
Real facet_attenuation(Real n_h, Real n_v, Real n_l, Real v_h) {
  const Real nearer = smaller(n_v, n_l);
  return smaller(constant<Real>(1), constant<Real>(2) * n_h * nearer / v_h);
}

}  // namespace maquette::firmware
