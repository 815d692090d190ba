#pragma once

#include "firmware/arithmetic/leg.hpp"
#include "firmware/ray_query.hpp"

/// What is handed over between those who share out the process of a pixel, in words of 32 bits.
namespace maquette::firmware::messages {

inline constexpr int k_vector = 3;
inline constexpr int k_color = 3;
inline constexpr int k_node = 1;
inline constexpr int k_count = 1;
/// The place in the tree, and which operands have been missed on the way to it.
inline constexpr int k_way = 2;
/// Distance; leaf; face, way and medium.
inline constexpr int k_crossing = 3;
/// The same of a known leaf.
inline constexpr int k_hit = 2;
/// Position, normal, clearance; leaf; surface and media; face and side.
inline constexpr int k_surface_point = 2 * k_vector + 4;
/// Direction, cosine, index, whether it is in matter.
inline constexpr int k_view = k_vector + 3;
/// Origin and direction; weight; leaf left behind; depth and medium.
inline constexpr int k_pending_ray = 2 * k_vector + k_color + 2;

/// A ray as primitives are intersected with it: a primary one has its origin or its direction from
/// the observer, and a reach only where that is shortened.
template <class Real>
int line_of(const Frame<Real>& frame, const RayQuery<Real>& query) {
  return query.is_primary ? k_vector + (frame.database.needs.large_unions ? 1 : 0)
                          : 2 * k_vector + 1;
}

/// A ray as extents are compared with it: a primary one has column and row in one word, a secondary
/// one the leaf left behind and its medium.
template <class Real>
int ray_of(const Frame<Real>& frame, const RayQuery<Real>& query) {
  return line_of(frame, query) + (query.is_primary ? 1 : 2) +
         (frame.database.needs.large_unions ? k_vector : 0);
}

/// A ray on its way through the tree.
template <class Real>
LegMessages of_walk(const Frame<Real>& frame, const RayQuery<Real>& query) {
  const int ray = ray_of(frame, query);
  return {ray + k_node, k_way, k_way, ray + k_way + k_count};
}

/// A ray and a leaf.
template <class Real>
LegMessages of_intersection(const Frame<Real>& frame, const RayQuery<Real>& query) {
  return {line_of(frame, query) + k_node, k_count};
}

/// The crossings of two operands, with the node and both counts. Where faces coincide the ray is
/// asked.
template <class Real>
LegMessages of_combination(const Frame<Real>& frame, const RayQuery<Real>& query,
                           std::int32_t crossings) {
  return {line_of(frame, query) + k_node + 2 * k_count + k_crossing * crossings, k_count};
}

/// A light's ray and its crossings with a node that holds transparent bodies.
template <class Real>
LegMessages of_passage(const Frame<Real>& frame, const RayQuery<Real>& query,
                       std::int32_t crossings) {
  return {ray_of(frame, query) + k_color + k_count + k_crossing * crossings, k_color + 1};
}

/// A ray with its weight, depth and crossings, of which a light's ray may be asked, once a point is
/// seen: that keeps point, view, weight, what was summed and the light's number.
template <class Real>
LegMessages of_photometry(const Frame<Real>& frame, const RayQuery<Real>& query,
                          std::int32_t crossings) {
  const Needs& needs = frame.database.needs;
  const int point = k_surface_point + (needs.textured ? k_color : 0);
  const int kept = point + (needs.specular ? k_view : 0) + 2 * k_color + 1;
  const int light_ray = 2 * k_vector + 3 + (needs.large_unions ? k_vector : 0);
  return {ray_of(frame, query) + k_color + 1 + k_count + k_crossing * crossings,
          k_color + (needs.depth && query.is_primary ? 1 : 0), kept + light_ray,
          kept + k_color + 1};
}

}  // namespace maquette::firmware::messages
