#pragma once

#include "firmware/extent.hpp"
#include "firmware/primitives/primitive_table.hpp"

/// What is asked of the tree: a ray, and which extents it may meet.
namespace maquette::firmware {

/// A ray in the screen frame and what is known of it. A primary ray starts at the eye, the origin
/// of the screen frame, or, of a parallel view, in the plane of the eye, and is tested against
/// rectangles; a secondary one has a unit direction and is tested against spheres.
template <class Real>
struct RayQuery {
  Ray<Real> ray;
  Real reach;  ///< what lies farther does not matter
  bool is_primary;
  std::int16_t column;  ///< of a primary ray
  std::int16_t row;
  /// A leaf whose outside the ray has just left: what a line meets in one segment it will not meet
  /// again.
  NodeIndex left_behind = k_no_node;
  SurfaceIndex medium = k_void;  ///< in which a secondary ray starts
  Vector<Real> inverse{};        ///< 1 / direction, of a query against boxes
};

/// Whether a node is the leaf that the ray has left behind.
template <class Real>
bool is_left_behind(const Database<Real>& database, const RayQuery<Real>& query, NodeIndex node) {
  return node == query.left_behind && primitive_of<Real>(database.leaves[node].kind).is_convex;
}

/// 1 / component, with a large number for 0.
template <class Real>
Real slab_scale(Real component) {
  const Real one = constant<Real>(1);
  return absolute(component) * far_away<Real>() > one ? one / component : far_away<Real>();
}

/// The query with what tests against boxes take.
template <class Real>
RayQuery<Real> against_boxes(const RayQuery<Real>& query) {
  RayQuery<Real> result = query;
  const Vector<Real>& direction = query.ray.direction;
  result.inverse = {slab_scale(direction.x), slab_scale(direction.y), slab_scale(direction.z)};
  return result;
}

/// Where a ray enters the box of an extent, behind the origin when that lies in it; far away when
/// the ray does not meet the box within its reach.
template <class Real>
[[gnu::noinline]] Real entry_into(const Extent<Real>& extent, const RayQuery<Real>& query) {
  charge<Real>(Operation::box);
  const Real far = far_away<Real>();
  if (!extent.bounded) {
    return -far;
  }
  charge<Real>(Operation::load, 6);
  const Vector<Real> to_low = (extent.box.low - query.ray.origin) * query.inverse;
  const Vector<Real> to_high = (extent.box.high - query.ray.origin) * query.inverse;
  const Vector<Real> in = lower(to_low, to_high);
  const Vector<Real> out = higher(to_low, to_high);
  const Real entry = larger(in.x, larger(in.y, in.z));
  // Longer by the rounding of the products (Ize, "Robust BVH Ray Traversal", 2013).
  const Real exit = smaller(out.x, smaller(out.y, out.z)) * (constant<Real>(1) + ulps<Real>(4));
  const bool is_met = entry <= exit && exit >= constant<Real>(0) && entry <= query.reach;
  return is_met ? entry : far;
}

/// Whether the ray may meet a node, by the paper's rectangle or sphere, or, where the scene has
/// large unions, by the box.
template <class Real>
bool may_meet(const Frame<Real>& frame, const RayQuery<Real>& query, NodeIndex node) {
  const InFunction<Real> here(Function::extents);
  const Extent<Real>& extent = frame.prepared.extents[node];
  if (frame.database.tests_rectangles && query.is_primary) {
    charge<Real>(Operation::load, 2);
    charge<Real>(Operation::rectangle);
    if (!extent.rectangle.contains(query.column, query.row)) {
      frame.database.note(ExtentKind::rectangle, node, false);
      return false;
    }
    frame.database.note(ExtentKind::rectangle, node, true);
  }
  if (frame.database.needs.large_unions) {
    if (!frame.database.tests_boxes) {
      return true;
    }
    const bool is_met = entry_into(extent, query) < far_away<Real>();
    frame.database.note(ExtentKind::box, node, is_met);
    return is_met;
  }
  if (query.is_primary || !extent.bounded || !frame.database.tests_spheres) {
    return true;
  }
  const bool is_met = meets(query.ray, query.reach, extent.sphere);
  frame.database.note(ExtentKind::sphere, node, is_met);
  return is_met;
}

}  // namespace maquette::firmware
