#pragma once

#include "firmware/facets.hpp"
#include "firmware/shadow.hpp"

/// Luminance of a surface under the light sources (paper, section III.1):
/// R = s R_s + d R_d with R_s = F D G / (pi cos theta cos phi).
namespace maquette::firmware {

/// Reflected share per colour of a surface at a given angle of incidence.
template <class Real>
Color<Real> fresnel_factor(const Surface<Real>& surface, Real cosine, Real index) {
  if (!surface.metal) {
    const Real reflected = dielectric_border(cosine, index).reflected;
    return {reflected, reflected, reflected};
  }
  charge<Real>(Operation::load, 6);
  return {conductor_reflection(cosine, surface.index.x, surface.extinction.x),
          conductor_reflection(cosine, surface.index.y, surface.extinction.y),
          conductor_reflection(cosine, surface.index.z, surface.extinction.z)};
}

/// A point as the observer of the ray sees it.
template <class Real>
struct View {
  Vector<Real> towards;  ///< unit vector back along the ray
  Real cosine;           ///< of the angle phi between normal and view, above 0
  Real index;            ///< of the far medium relative to the near one
};

template <class Real>
View<Real> view_of(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                   const Vector<Real>& unit_direction) {
  View<Real> view;
  view.towards = -unit_direction;
  // Rounding may turn a grazing view behind the surface or make a frontal one exceed 1.
  view.cosine =
      larger(ulps<Real>(1), smaller(constant<Real>(1), glm::dot(point.normal, view.towards)));
  view.index = relative_index(frame.database, point.before, point.after, point.surface);
  return view;
}

/// D G / (pi cos phi) for the facets whose normal is `half`; the cosine of the incidence cancels
/// against that of the illumination.
template <class Real>
Real facet_term(const Surface<Real>& surface, Real n_h, Real n_v, Real n_l, Real v_h) {
  return facet_distribution(surface, n_h) * facet_attenuation(n_h, n_v, n_l, v_h) /
         (constant<Real>(elementary::k_pi) * n_v);
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
  return fresnel_factor(surface, v_h, view.index) * facet_term(surface, n_h, view.cosine, n_l, v_h);
}

/// The same with 1 - F for light from behind a transparent surface: a facet whose normal is the
/// half vector of refraction bends it into the view (paper, section III.2).
template <class Real>
[[gnu::noinline]] Real glossy_transmission(const Surface<Real>& surface,
                                           const SurfacePoint<Real>& point, const View<Real>& view,
                                           const Vector<Real>& to_light, Real n_l) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Vector<Real> sum = view.towards + to_light * view.index;
  if (!(glm::dot(sum, sum) > zero)) {
    return zero;  // equal indices: light goes straight on, no facet bends it
  }
  const Vector<Real> half = normalize(sum);
  const Real n_h = smaller(one, absolute(glm::dot(point.normal, half)));
  const Real v_h = smaller(one, absolute(glm::dot(view.towards, half)));
  if (!(v_h > ulps<Real>(1))) {
    return zero;
  }
  const Real transmitted = one - dielectric_border(v_h, view.index).reflected;
  return transmitted * facet_term(surface, n_h, view.cosine, n_l, v_h);
}

/// One light source at a point, as seen from the point.
template <class Real>
struct Incidence {
  Vector<Real> to_light;  ///< unit vector
  Real distance;
  Real cosine;  ///< to the normal; negative for light from behind
};

/// `way` from the point to the source and its component along the normal.
template <class Real>
Incidence<Real> incidence_of(const Vector<Real>& way, Real along_normal) {
  const Real distance = length(way);
  const Real inverse = constant<Real>(1) / distance;
  return {way * inverse, distance, along_normal * inverse};
}

/// Reflectance times cosine of the incidence, per colour, for light from the viewer's side.
template <class Real>
Color<Real> reflectance(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                        const View<Real>& view, const Incidence<Real>& incidence) {
  const Surface<Real>& surface = frame.database.surfaces[point.surface];
  charge<Real>(Operation::load);
  const Real zero = constant<Real>(0);
  Color<Real> result(zero, zero, zero);
  if (surface.specular < constant<Real>(1)) {
    charge<Real>(Operation::load, 3);
    result = frame.prepared.surfaces[point.surface].diffuse * incidence.cosine;
  }
  if (surface.specular > zero) {
    result += glossy_reflection(surface, point, view, incidence.to_light, incidence.cosine) *
              surface.specular;
  }
  return result;
}

/// Luminance towards the view that one source causes. Counts its shadow ray.
template <class Real>
Color<Real> light_from(const Frame<Real>& frame, std::uint16_t light,
                       const SurfacePoint<Real>& point, const View<Real>& view,
                       Crossing<Real>* area, RayCounts& rays) {
  charge<Real>(Operation::light);
  const Surface<Real>& surface = frame.database.surfaces[point.surface];
  const Real zero = constant<Real>(0);
  charge<Real>(Operation::load, 6);
  const Vector<Real> way = frame.prepared.light_positions[light] - point.position;
  const Real along_normal = glm::dot(point.normal, way);
  const bool is_behind = !(along_normal > zero);
  // Only where a ray leaves a transparent body is a source seen through its surface; where it
  // enters one, the refracted ray will find that.
  const bool passes = surface.transparent && point.before != k_void && point.after == k_void;
  if (is_behind && (!passes || !(along_normal < zero))) {
    return {zero, zero, zero};
  }
  const Incidence<Real> incidence = incidence_of(way, along_normal);
  Color<Real> arriving = frame.database.lights[light].intensity;
  if (frame.database.needs.shadows) {
    ++rays.shadow;
    const Vector<Real> origin = is_behind ? far_departure(point) : departure(point);
    const NodeIndex left = is_behind ? far_left_behind(point) : left_behind(point);
    if (!reaches(frame, {origin, incidence.to_light}, incidence.distance, left, area, arriving)) {
      return {zero, zero, zero};
    }
  }
  if (is_behind) {
    return arriving *
           (surface.specular *
            glossy_transmission(surface, point, view, incidence.to_light, -incidence.cosine));
  }
  return arriving * reflectance(frame, point, view, incidence);
}

/// Luminance towards the view under all sources and the ambient light.
template <class Real>
Color<Real> direct_light(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                         const View<Real>& view, Crossing<Real>* area, RayCounts& rays) {
  const Real zero = constant<Real>(0);
  Color<Real> sum(zero, zero, zero);
  if (frame.database.needs.ambient) {
    charge<Real>(Operation::load, 3);
    sum = frame.prepared.surfaces[point.surface].ambient;
  }
  for (std::uint16_t light = 0; light < frame.database.light_count; ++light) {
    sum += light_from(frame, light, point, view, area, rays);
  }
  return sum;
}

}  // namespace maquette::firmware
