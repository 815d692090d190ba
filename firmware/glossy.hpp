#pragma once

#include "firmware/facets.hpp"
#include "firmware/fresnel.hpp"
#include "firmware/surface_point.hpp"

/// What the facets of a surface send towards a view: R_s = F D G / (pi cos theta cos phi) (paper,
/// section III.1), and what they let through.
namespace maquette::firmware {

/// A point as the observer of the ray sees it.
template <class Real>
struct View {
  Vector<Real> towards;  ///< unit vector back along the ray
  Real cosine;           ///< of the angle phi between normal and view, above 0
  Real index;            ///< of the far medium relative to the near one; the near one's of a metal
  bool is_in_matter;     ///< the near medium is not the void
};

template <class Real>
View<Real> view_of(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                   const Vector<Real>& unit_direction) {
  View<Real> view;
  view.towards = -unit_direction;
  // Rounding may turn a grazing view behind the surface or make a frontal one exceed 1.
  view.cosine =
      larger(ulps<Real>(1), smaller(constant<Real>(1), glm::dot(point.normal, view.towards)));
  view.is_in_matter = point.before != k_void;
  view.index = frame.database.surfaces[point.surface].metal
                   ? index_before(frame.database, point.before)
                   : relative_index(frame.database, point.before, point.after, point.surface);
  return view;
}

/// Reflected share per colour of a metal. Its index and extinction, which are given against the
/// void, count relative to the index of the matter that it lies in.
template <class Real>
[[gnu::noinline]] Color<Real> metal_reflection(const Surface<Real>& surface, Real cosine,
                                               const View<Real>& view) {
  charge<Real>(Operation::load, 6);
  Color<Real> index = surface.index;
  Color<Real> extinction = surface.extinction;
  if (view.is_in_matter) {
    const Real inverse = constant<Real>(1) / view.index;
    index *= inverse;
    extinction *= inverse;
  }
  return {conductor_reflection(cosine, index.x, extinction.x),
          conductor_reflection(cosine, index.y, extinction.y),
          conductor_reflection(cosine, index.z, extinction.z)};
}

/// Reflected share per colour of a surface at a given angle of incidence.
template <class Real>
[[gnu::noinline]] Color<Real> fresnel_factor(const Surface<Real>& surface, Real cosine,
                                             const View<Real>& view) {
  if (surface.metal) {
    return metal_reflection(surface, cosine, view);
  }
  const Real reflected = dielectric_border(cosine, view.index).reflected;
  return {reflected, reflected, reflected};
}

/// R_s cos(theta) for light from the viewer's side.
template <class Real>
[[gnu::noinline]] Color<Real> glossy_reflection(const Surface<Real>& surface,
                                                const SurfacePoint<Real>& point,
                                                const View<Real>& view,
                                                const Vector<Real>& to_light, Real n_l) {
  const Vector<Real> half = normalize(view.towards + to_light);
  const Real one = constant<Real>(1);
  const Real n_h = smaller(one, absolute(glm::dot(point.normal, half)));
  const Real v_h = larger(ulps<Real>(1), smaller(one, glm::dot(view.towards, half)));
  // The cosine of the incidence cancels against that of the illumination.
  const Real facets =
      facet_distribution(surface, n_h) * facet_attenuation(n_h, view.cosine, n_l, v_h);
  return fresnel_factor(surface, v_h, view) *
         (facets / (constant<Real>(elementary::k_pi) * view.cosine));
}

/// The same with 1 - F for light from behind a transparent surface: a facet whose normal is the
/// half vector of refraction bends it into the view (paper, section III.2). A solid angle of light
/// belongs to one of half vectors that is n^2 |l.h| / |v + n l|^2 times as large (Walter et al.
/// 2007, equation 17), with n the index on the light's side relative to the view's.
template <class Real>
[[gnu::noinline]] Real glossy_transmission(const Surface<Real>& surface,
                                           const SurfacePoint<Real>& point, const View<Real>& view,
                                           const Vector<Real>& to_light, Real n_l) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Vector<Real> sum = view.towards + to_light * view.index;
  const Real along_view = glm::dot(view.towards, sum);
  const Real along_light = glm::dot(to_light, sum);
  // View and light lie on two sides of the facet, and the view on that of the surface's normal.
  // With equal indices light goes straight on: no facet bends it.
  const bool is_towards_view = along_view > zero;
  const bool is_bent = is_towards_view ? along_light < zero : along_light > zero;
  const Real along_normal = glm::dot(point.normal, sum);
  if (!is_bent || !(is_towards_view ? along_normal > zero : along_normal < zero)) {
    return zero;
  }
  const Real sum_squared = glm::dot(sum, sum);
  const Real inverse = one / square_root(sum_squared);
  const Real n_h = smaller(one, absolute(along_normal) * inverse);
  const Real v_h = smaller(one, absolute(along_view) * inverse);
  const Real l_h = smaller(one, absolute(along_light) * inverse);
  if (!(v_h > ulps<Real>(1)) || !(l_h > ulps<Real>(1))) {
    return zero;
  }
  const Real transmitted = one - dielectric_border(v_h, view.index).reflected;
  const Real facets =
      facet_distribution(surface, n_h) * facet_attenuation(n_h, view.cosine, n_l, v_h, l_h);
  const Real spread = constant<Real>(4) * v_h * l_h * (view.index * view.index) / sum_squared;
  return transmitted * facets * spread / (constant<Real>(elementary::k_pi) * view.cosine);
}

}  // namespace maquette::firmware
