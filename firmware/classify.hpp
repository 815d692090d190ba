#pragma once

#include "firmware/combine.hpp"

/// From a ray to its crossings with a node of the tree: extents, intersections in local frames,
/// combination along the composites (paper, section V.2.3.1.2).
namespace maquette::firmware {

/// Makes crossings with a leaf of hits, written from `first` on; spans behind the origin or beyond
/// the reach are left out. Returns their number.
template <class Real>
std::int32_t crossings_of_hits(const RayQuery<Real>& query, NodeIndex node, SurfaceIndex surface,
                               const Hit<Real>* hits, int hit_count, Crossing<Real>* first) {
  const InFunction<Real> here(Function::classification);
  std::int32_t count = 0;
  for (int i = 0; i < hit_count; i += 2) {
    const Hit<Real>& in = hits[i];
    const Hit<Real>& out = hits[i + 1];
    if (out.distance <= constant<Real>(0) || in.distance > query.reach) {
      continue;
    }
    charge<Real>(Operation::span);
    returns_also<Real>(2 * messages::k_hit);
    first[count++] = {in.distance, node, in.face, false, surface};
    first[count++] = {out.distance, node, out.face, true, k_void};
  }
  return count;
}

/// Crossings of a ray with a leaf in which it has at most `limit` hits.
template <int limit, Projection projection, class Real>
[[gnu::always_inline]] inline std::int32_t cross_primitive(const Frame<Real>& frame,
                                                           const RayQuery<Real>& query,
                                                           NodeIndex node, Crossing<Real>* first) {
  const InLeg<Real> leg(
      Stage::intersection, [&frame, &query] { return messages::of_intersection(frame, query); },
      static_cast<int>(frame.database.leaves[node].kind));
  const InFunction<Real> here(intersection_of(frame.database.leaves[node].kind));
  charge<Real>(Operation::leaf);
  const Leaf<Real>& leaf = frame.database.leaves[node];
  charge<Real>(Operation::load, 2);
  Hit<Real> hits[limit];
  const int hit_count = primitive_of<Real>(leaf.kind).intersect(
      local_ray<projection>(frame.prepared.leaves[node], query),
      frame.database.parameters + leaf.first_parameter, hits);
  return crossings_of_hits(query, node, leaf.surface, hits, hit_count, first);
}

template <class Real>
[[gnu::noinline]] std::int32_t cross_convex(const Frame<Real>& frame, const RayQuery<Real>& query,
                                            NodeIndex node, Crossing<Real>* first) {
  return is_parallel(frame.database)
             ? cross_primitive<k_convex_hit_limit, Projection::parallel>(frame, query, node, first)
             : cross_primitive<k_convex_hit_limit, Projection::perspective>(frame, query, node,
                                                                            first);
}

/// Apart, so that scenes without such primitives spare its stack.
template <class Real>
[[gnu::noinline]] std::int32_t cross_spans(const Frame<Real>& frame, const RayQuery<Real>& query,
                                           NodeIndex node, Crossing<Real>* first) {
  return is_parallel(frame.database)
             ? cross_primitive<k_primitive_hit_limit, Projection::parallel>(frame, query, node,
                                                                            first)
             : cross_primitive<k_primitive_hit_limit, Projection::perspective>(frame, query, node,
                                                                               first);
}

template <class Real>
std::int32_t cross_leaf(const Frame<Real>& frame, const RayQuery<Real>& query, NodeIndex node,
                        Crossing<Real>* first) {
  if (frame.database.needs.several_spans) {
    if (!primitive_of<Real>(frame.database.leaves[node].kind).is_convex) {
      return cross_spans(frame, query, node, first);
    }
  }
  return cross_convex(frame, query, node, first);
}

/// Crossings of a ray with a node, written from `first` on, in order; returns their number. Where
/// the first operand of a difference or an intersection is missed the second is not looked at. The
/// space needed behind `first` is what CrossingNeeds says (work_area.hpp).
template <class Real>
std::int32_t cross(const Frame<Real>& frame, const RayQuery<Real>& query, NodeIndex node,
                   Crossing<Real>* first) {
  charge<Real>(Operation::node);
  if (is_left_behind(frame.database, query, node) || !may_meet(frame, query, node)) {
    return 0;
  }
  if (frame.database.is_leaf(node)) {
    return cross_leaf(frame, query, node, first);
  }
  const Composite& composite = frame.database.composite(node);
  charge<Real>(Operation::load, 2);
  const std::int32_t a_count = cross(frame, query, composite.children[0], first);
  const bool second_is_kept = composite.combination == k_keeps_second;
  if (a_count == 0 && !second_is_kept) {
    return 0;
  }
  const std::int32_t b_count = cross(frame, query, composite.children[1], first + a_count);
  if (b_count == 0) {
    return composite.combination == k_drops_first ? 0 : a_count;
  }
  if (a_count == 0) {
    return b_count;
  }
  return combine(frame, query, composite.combination, first, a_count, b_count);
}

}  // namespace maquette::firmware
