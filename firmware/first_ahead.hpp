#pragma once

#include "firmware/face_point.hpp"

/// Where a ray starts among the crossings of its line.
namespace maquette::firmware {

/// Index of the first crossing in front of the origin, `count` when there is none. `before` becomes
/// the medium that the ray travels in until there.
template <class Real>
std::int32_t first_ahead(const Crossing<Real>* crossings, std::int32_t count,
                         SurfaceIndex& before) {
  before = k_void;
  std::int32_t i = 0;
  while (i < count && !(crossings[i].distance > constant<Real>(0))) {
    before = crossings[i++].medium;
  }
  return i;
}

/// Whether a ray that is known to start in a medium may start in another one of a part of the
/// scene: from the void in no body, from a transparent body in no opaque one.
template <class Real>
bool may_start_in(const Frame<Real>& frame, const RayQuery<Real>& query, SurfaceIndex medium) {
  if (medium == k_void || query.is_primary) {
    return true;
  }
  const Surface<Real>* surfaces = frame.database.surfaces;
  return query.medium != k_void &&
         (surfaces[medium].transparent || !surfaces[query.medium].transparent);
}

/// How far the origin of a ray lies off a face that it crosses, measured across the face.
template <class Real>
Real distance_to_face(const Frame<Real>& frame, const RayQuery<Real>& query,
                      const Crossing<Real>& crossing) {
  const Real along = absolute(crossing.distance);
  if (!(along < far_away<Real>())) {
    return along;
  }
  return along * absolute(glm::dot(face_point(frame, query, crossing).normal, query.ray.direction));
}

/// The same for a ray of which it is known where it starts. Near creases rounding may put its
/// origin into a body beside the one that it leaves: then it stands at the nearer of both faces.
template <class Real>
[[gnu::noinline]] std::int32_t first_ahead(const Frame<Real>& frame, const RayQuery<Real>& query,
                                           const Crossing<Real>* crossings, std::int32_t count,
                                           SurfaceIndex& before) {
  const std::int32_t ahead = first_ahead(crossings, count, before);
  if (may_start_in(frame, query, before)) {
    return ahead;
  }
  const SurfaceIndex behind = ahead > 1 ? crossings[ahead - 2].medium : k_void;
  const bool is_entering = may_start_in(frame, query, behind);
  const bool is_leaving = ahead < count && may_start_in(frame, query, crossings[ahead].medium);
  if (is_leaving && !(is_entering && distance_to_face(frame, query, crossings[ahead - 1]) <
                                         distance_to_face(frame, query, crossings[ahead]))) {
    before = crossings[ahead].medium;
    return ahead + 1;
  }
  if (is_entering) {
    before = behind;
    return ahead - 1;
  }
  return ahead;
}

}  // namespace maquette::firmware
