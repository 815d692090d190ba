#pragma once

#include "firmware/classify.hpp"
#include "firmware/first_ahead.hpp"

/// Rays against large unions: the nearer child first, and nothing behind the first opaque matter.
namespace maquette::firmware {

/// Where a ray enters a node's box; far away when it may not meet the node.
template <class Real>
Real entry_of(const Frame<Real>& frame, const RayQuery<Real>& query, NodeIndex node) {
  const InFunction<Real> here(Function::extents);
  const Extent<Real>& extent = frame.prepared.extents[node];
  charge<Real>(Operation::rectangle);
  if (frame.database.tests_rectangles && query.is_primary) {
    if (!extent.rectangle.contains(query.column, query.row)) {
      frame.database.note(ExtentKind::rectangle, node, false);
      charge<Real>(Operation::load, 2);
      return far_away<Real>();
    }
    frame.database.note(ExtentKind::rectangle, node, true);
  }
  if (!frame.database.tests_boxes) {
    return -far_away<Real>();
  }
  const Real entry = entry_into(extent, query);
  frame.database.note_entry(node, entry);
  return entry;
}

/// Ends the reach behind the first opaque matter ahead: whoever lies farther is not seen.
template <class Real>
void shorten(const Frame<Real>& frame, RayQuery<Real>& query, const Crossing<Real>* crossings,
             std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    const Crossing<Real>& crossing = crossings[i];
    if (crossing.distance > constant<Real>(0) && crossing.medium != k_void &&
        !frame.database.surfaces[crossing.medium].transparent) {
      // What coincides with it may be what is seen.
      query.reach = smaller(query.reach, crossing.distance + frame.prepared.coarse_tolerance);
      return;
    }
  }
}

/// Crossings of a ray with a node that it may meet, in order as far as the first opaque matter
/// ahead; the query's reach is shortened to it.
template <class Real>
std::int32_t cross_nearest(const Frame<Real>& frame, RayQuery<Real>& query, NodeIndex node,
                           Crossing<Real>* first) {
  charge<Real>(Operation::node);
  const Database<Real>& database = frame.database;
  const Real far = far_away<Real>();
  if (database.is_leaf(node) || database.composite(node).combination != k_keeps_all) {
    const std::int32_t count = cross(frame, query, node, first);
    shorten(frame, query, first, count);
    return count;
  }
  const NodeIndex* children = database.composite(node).children;
  charge<Real>(Operation::load, 2);
  const Real entries[] = {entry_of(frame, query, children[0]), entry_of(frame, query, children[1])};
  const int nearer = entries[1] < entries[0] ? 1 : 0;
  std::int32_t near_count = 0;
  if (entries[nearer] < far) {
    near_count = cross_nearest(frame, query, children[nearer], first);
  }
  std::int32_t far_count = 0;
  if (entries[1 - nearer] < far && entries[1 - nearer] <= query.reach) {
    far_count = cross_nearest(frame, query, children[1 - nearer], first + near_count);
  }
  if (near_count == 0 || far_count == 0) {
    return near_count + far_count;
  }
  return combine(frame, query, BooleanOperator::union_of, first, near_count, far_count);
}

/// Crossings of a ray with a scene of large unions, of which those behind the first ahead may be
/// left out.
template <class Real>
[[gnu::noinline]] std::int32_t cross_ahead(const Frame<Real>& frame, const RayQuery<Real>& query,
                                           Crossing<Real>* first) {
  const Database<Real>& database = frame.database;
  const RayQuery<Real> boxed = against_boxes(query);
  RayQuery<Real> shortened = boxed;
  if (!may_meet(frame, boxed, database.root)) {
    return 0;
  }
  const std::int32_t count = cross_nearest(frame, shortened, database.root, first);
  SurfaceIndex before = k_void;
  first_ahead(first, count, before);
  // What ends opaque matter around the origin may lie behind the beginning of other such matter.
  if (before != k_void && !database.surfaces[before].transparent) {
    return cross(frame, boxed, database.root, first);
  }
  return count;
}

/// Crossings of a ray with the whole scene, right as far as the first ahead.
template <class Real>
std::int32_t cross_scene(const Frame<Real>& frame, const RayQuery<Real>& query,
                         Crossing<Real>* first) {
  const InLeg<Real> leg(Stage::extents, [&] { return messages::of_walk(frame, query); });
  const InFunction<Real> here(Function::classification);
  return frame.database.needs.large_unions ? cross_ahead(frame, query, first)
                                           : cross(frame, query, frame.database.root, first);
}

}  // namespace maquette::firmware
