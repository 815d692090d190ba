#pragma once

#include "firmware/glossy.hpp"
#include "firmware/light_shape.hpp"
#include "firmware/shadow.hpp"

/// Luminance of a surface under the light sources (paper, section III.1): R = s R_s + d R_d.
namespace maquette::firmware {

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
    if (frame.database.needs.textured) {
      result *= point.tint;
    }
  }
  if (surface.specular > zero) {
    result += glossy_reflection(surface, point, view, incidence.to_light, incidence.cosine) *
              surface.specular;
  }
  return result;
}

/// Luminance towards the view that a source behind a transparent surface causes, of whose light
/// `arriving` sets out. Of all the borders on its way a light is bent at the one that it meets
/// first, wherever that is; the rays of the tree go straight through it at the others, so that none
/// is counted twice.
template <class Real, class Count>
[[gnu::noinline]] Color<Real> light_through(const Frame<Real>& frame,
                                            const SurfacePoint<Real>& point, const View<Real>& view,
                                            const Incidence<Real>& incidence, Crossing<Real>* area,
                                            RayNumbers<Count>& rays, Color<Real> arriving) {
  const Surface<Real>& surface = frame.database.surfaces[point.surface];
  if (frame.database.needs.shadows) {
    ++rays.shadow;
    if (!reaches_freely(frame, {far_departure(point), incidence.to_light}, incidence.distance,
                        far_left_behind(point), point.after, area)) {
      return arriving * constant<Real>(0);
    }
  } else if (point.after != k_void) {
    return arriving * constant<Real>(0);  // nobody looks where the source is: outside, as a rule
  }
  if (point.after != k_void && surface.absorbing) {
    arriving *= transmitted_over(surface, incidence.distance);
  }
  return arriving * (surface.specular * glossy_transmission(surface, point, view,
                                                            incidence.to_light, -incidence.cosine));
}

/// Luminance towards the view that one source causes. Counts its shadow ray.
template <class Real, class Count>
Color<Real> light_from(const Frame<Real>& frame, std::uint16_t light,
                       const SurfacePoint<Real>& point, const View<Real>& view,
                       Crossing<Real>* area, RayNumbers<Count>& rays) {
  charge<Real>(Operation::light);
  LightAsked<Real>::put(light);
  const Surface<Real>& surface = frame.database.surfaces[point.surface];
  const Real zero = constant<Real>(0);
  charge<Real>(Operation::load, 6);
  const Vector<Real> way = frame.prepared.light_positions[light] - point.position;
  const Real along_normal = glm::dot(point.normal, way);
  const bool is_behind = !(along_normal > zero);
  if (is_behind && (!surface.transparent || !(along_normal < zero))) {
    return {zero, zero, zero};
  }
  const Incidence<Real> incidence = incidence_of(way, along_normal);
  Color<Real> arriving = frame.database.lights[light].intensity;
  if (frame.database.needs.shaped_lights) {
    const Real share = shaped_share(frame, light, incidence.to_light, incidence.distance);
    if (!(share > zero)) {
      return {zero, zero, zero};
    }
    arriving *= share;
  }
  if (is_behind) {
    return light_through(frame, point, view, incidence, area, rays, arriving);
  }
  if (frame.database.needs.shadows) {
    ++rays.shadow;
    if (!reaches(frame, {departure(point), incidence.to_light}, incidence.distance,
                 left_behind(point), point.before, area, arriving)) {
      return {zero, zero, zero};
    }
  }
  return arriving * reflectance(frame, point, view, incidence);
}

/// Luminance towards the view under all sources and the ambient light.
template <class Real, class Count>
Color<Real> direct_light(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                         const View<Real>& view, Crossing<Real>* area, RayNumbers<Count>& rays) {
  const Real zero = constant<Real>(0);
  Color<Real> sum(zero, zero, zero);
  if (frame.database.needs.ambient) {
    charge<Real>(Operation::load, 3);
    sum = frame.prepared.surfaces[point.surface].ambient;
    if (frame.database.needs.textured) {
      sum *= point.tint;
    }
  }
  for (std::uint16_t light = 0; light < frame.database.light_count; ++light) {
    sum += light_from(frame, light, point, view, area, rays);
  }
  return sum;
}

}  // namespace maquette::firmware
