#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/first_ahead.hpp"
#include "firmware/fresnel.hpp"
#include "firmware/surface_point.hpp"

/// Shadow rays: opaque bodies stop the light of a source, transparent ones attenuate it by
/// absorption over the thickness and at each passage of a surface (paper, section III.1, figure 2).
namespace maquette::firmware {

/// What a body of this surface lets through over a length, per colour.
template <class Real>
[[gnu::noinline]] Color<Real> transmitted_over(const Surface<Real>& surface, Real length) {
  charge<Real>(Operation::load, 3);
  return {exponential(-(surface.absorption.x * length)),
          exponential(-(surface.absorption.y * length)),
          exponential(-(surface.absorption.z * length))};
}

/// Attenuates by the passage of a transparent surface, of which the specular share lets light
/// through. The straight ray stands for a refracted one whose angle is that on the thinner side, so
/// F is taken there; both ways give the same.
template <class Real>
[[gnu::noinline]] void pass_surface(const Frame<Real>& frame, const RayQuery<Real>& query,
                                    const Crossing<Real>& crossing, SurfaceIndex before,
                                    Color<Real>& light) {
  const SurfacePoint<Real> point = surface_point(frame, query, crossing, before);
  const Real one = constant<Real>(1);
  const Real index = relative_index(frame.database, before, point.after, point.surface);
  const Real cosine = smaller(one, absolute(glm::dot(point.normal, query.ray.direction)));
  charge<Real>(Operation::load);
  const Real reflected = dielectric_border(cosine, index < one ? one / index : index).reflected;
  light *= frame.database.surfaces[point.surface].specular * (one - reflected);
}

/// Whether a medium lets no light through.
template <class Real>
bool is_opaque(const Surface<Real>* surfaces, SurfaceIndex medium) {
  return medium != k_void && !surfaces[medium].transparent;
}

/// Attenuates `light` by the crossings of a node between the origin and the reach. Returns false
/// when an opaque body stops it.
template <class Real>
[[gnu::noinline]] bool pass_crossings(const Frame<Real>& frame, const RayQuery<Real>& query,
                                      const Crossing<Real>* crossings, std::int32_t count,
                                      Color<Real>& light) {
  const InLeg<Real> leg(Stage::photometry,
                        [&] { return messages::of_passage(frame, query, count); });
  const InFunction<Real> here(Function::photometry);
  const Surface<Real>* surfaces = frame.database.surfaces;
  SurfaceIndex medium = k_void;
  std::int32_t i = first_ahead(frame, query, crossings, count, medium);
  Real from = constant<Real>(0);
  for (; !is_opaque(surfaces, medium); ++i) {
    const bool is_last = i == count || crossings[i].distance > query.reach;
    const Real to = is_last ? query.reach : crossings[i].distance;
    if (medium != k_void && surfaces[medium].absorbing) {
      light *= transmitted_over(surfaces[medium], to - from);
    }
    if (is_last) {
      return true;
    }
    if (!is_opaque(surfaces, crossings[i].medium)) {
      pass_surface(frame, query, crossings[i], medium, light);
    }
    from = to;
    medium = crossings[i].medium;
  }
  return false;
}

/// Whether opaque matter lies between the origin and the reach: what the combination leaves of the
/// operands' spans may be all behind or beyond.
template <class Real>
bool is_stopped(const Frame<Real>& frame, const RayQuery<Real>& query,
                const Crossing<Real>* crossings, std::int32_t count) {
  SurfaceIndex medium = k_void;
  const std::int32_t first = first_ahead(frame, query, crossings, count, medium);
  return medium != k_void || (first < count && !(crossings[first].distance > query.reach));
}

/// Attenuates `light` by a node between the origin of the ray and its reach. Returns false when an
/// opaque body stops it. The children of a union are looked at one by one unless both hold
/// transparent bodies, whose overlap only the combination knows.
template <class Real>
[[gnu::noinline]] bool pass_node(const Frame<Real>& frame, const RayQuery<Real>& query,
                                 NodeIndex node, Crossing<Real>* first, Color<Real>& light) {
  charge<Real>(Operation::node);
  const Database<Real>& database = frame.database;
  if (!database.is_leaf(node) && database.composite(node).combination == k_keeps_all) {
    const NodeIndex* children = database.composite(node).children;
    const bool first_is_transparent = frame.prepared.extents[children[0]].transparent;
    const bool second_is_transparent = frame.prepared.extents[children[1]].transparent;
    if (!first_is_transparent || !second_is_transparent) {
      if (!may_meet(frame, query, node)) {
        return true;
      }
      // The opaque child first: what it stops needs no attenuation.
      const int opaque = first_is_transparent ? 1 : 0;
      return pass_node(frame, query, children[opaque], first, light) &&
             pass_node(frame, query, children[1 - opaque], first, light);
    }
  }
  const std::int32_t count = cross(frame, query, node, first);
  if (!frame.prepared.extents[node].transparent) {
    return !is_stopped(frame, query, first, count);
  }
  return pass_crossings(frame, query, first, count, light);
}

/// What of a source's light reaches the origin of a ray of unit direction towards it, at the given
/// distance: `light` is attenuated. The ray leaves a body, or k_no_node, into a medium. Returns
/// false in shadow.
template <class Real>
bool reaches(const Frame<Real>& frame, const Ray<Real>& ray, Real distance, NodeIndex left_behind,
             SurfaceIndex medium, Crossing<Real>* area, Color<Real>& light) {
  const RayQuery<Real> query{ray, distance, false, 0, 0, left_behind, medium};
  const InRay<Real> towards(LightAsked<Real>::shadow_ray());
  const InLeg<Real> leg(Stage::extents, [&] { return messages::of_walk(frame, query); });
  const InFunction<Real> here(Function::classification);
  charge<Real>(Operation::shadow_ray);
  return pass_node(frame, frame.database.needs.large_unions ? against_boxes(query) : query,
                   frame.database.root, area, light);
}

/// Whether no surface at all lies between the origin of a ray of unit direction, which leaves a
/// body into a medium, and a distance.
template <class Real>
bool reaches_freely(const Frame<Real>& frame, const Ray<Real>& ray, Real distance,
                    NodeIndex left_behind, SurfaceIndex medium, Crossing<Real>* area) {
  const RayQuery<Real> query{ray, distance, false, 0, 0, left_behind, medium};
  const InRay<Real> towards(LightAsked<Real>::shadow_ray());
  const InLeg<Real> leg(Stage::extents, [&] { return messages::of_walk(frame, query); });
  const InFunction<Real> here(Function::classification);
  charge<Real>(Operation::shadow_ray);
  const std::int32_t count =
      cross(frame, frame.database.needs.large_unions ? against_boxes(query) : query,
            frame.database.root, area);
  SurfaceIndex around = k_void;
  const std::int32_t next = first_ahead(frame, query, area, count, around);
  return next == count || area[next].distance > distance;
}

}  // namespace maquette::firmware
