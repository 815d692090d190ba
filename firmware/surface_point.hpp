#pragma once

#include "firmware/classify.hpp"

namespace maquette::firmware {

/// A visible point of a surface in the screen frame, with the media on both sides.
template <class Real>
struct SurfacePoint {
  Vector<Real> position;
  Vector<Real> normal;   ///< unit length, on the side the ray comes from
  Real clearance;        ///< how far off the surface rounding can not reach it again
  SurfaceIndex surface;  ///< whose optical properties count
  SurfaceIndex before;   ///< medium on the ray's side
  SurfaceIndex after;
  NodeIndex leaf;  ///< whose surface it is
  std::uint8_t face;
  bool is_inside;    ///< the ray comes from the inside of that leaf
  Color<Real> tint;  ///< of the texture there, where the scene has any
};

/// Spacings by which a secondary ray starts off the surface, per unit of its coordinates: more than
/// the rounding of a change of frame there and back.
inline constexpr double k_clearance = 16;

/// The surface that is seen at a crossing. A transparent body shows its own matter everywhere, an
/// opaque one the surface of the leaf, so that a cut may have another colour.
template <class Real>
SurfaceIndex visible_surface(const Frame<Real>& frame, const Crossing<Real>& crossing,
                             SurfaceIndex before) {
  const Surface<Real>* surfaces = frame.database.surfaces;
  const SurfaceIndex matter = crossing.medium != k_void ? crossing.medium : before;
  const SurfaceIndex own = frame.database.leaves[crossing.leaf].surface;
  return surfaces[matter].transparent || surfaces[own].transparent ? matter : own;
}

/// The point of a crossing. Only crossings that survive the combination get here.
template <class Real>
SurfacePoint<Real> surface_point(const Frame<Real>& frame, const RayQuery<Real>& query,
                                 const Crossing<Real>& crossing, SurfaceIndex before) {
  const InFunction<Real> here(Function::points);
  const FacePoint<Real> settled = face_point(frame, query, crossing);
  SurfacePoint<Real> point;
  point.position = settled.position;
  // The way of the crossing, not a product with the direction: at a grazing point that rounding has
  // moved, its sign may be wrong.
  point.normal = crossing.outwards ? -settled.normal : settled.normal;
  charge<Real>(Operation::load);
  point.clearance = (frame.prepared.leaves[crossing.leaf].scale + magnitude(point.position)) *
                    ulps<Real>(k_clearance);
  point.surface = visible_surface(frame, crossing, before);
  point.before = before;
  point.after = crossing.medium;
  point.leaf = crossing.leaf;
  point.face = crossing.face;
  point.is_inside = crossing.outwards;
  return point;
}

/// The leaf that a ray leaving on the side of the normal need not be tested against again.
template <class Real>
NodeIndex left_behind(const SurfacePoint<Real>& point) {
  return point.is_inside ? k_no_node : point.leaf;
}

/// The same for a ray leaving on the other side.
template <class Real>
NodeIndex far_left_behind(const SurfacePoint<Real>& point) {
  return point.is_inside ? point.leaf : k_no_node;
}

/// The point from which a ray leaves the surface on the side of its normal.
template <class Real>
Vector<Real> departure(const SurfacePoint<Real>& point) {
  return point.position + point.normal * point.clearance;
}

/// The point from which a ray leaves on the other side.
template <class Real>
Vector<Real> far_departure(const SurfacePoint<Real>& point) {
  return point.position - point.normal * point.clearance;
}

/// Index of the medium on the ray's side.
template <class Real>
Real index_before(const Database<Real>& database, SurfaceIndex before) {
  charge<Real>(Operation::load);
  return before == k_void ? constant<Real>(1) : database.surfaces[before].index.x;
}

/// Index of the medium behind the point relative to that before it; 1 for the void.
template <class Real>
Real relative_index(const Database<Real>& database, SurfaceIndex before, SurfaceIndex after,
                    SurfaceIndex surface) {
  const Real one = constant<Real>(1);
  const Real far = after == k_void ? one : database.surfaces[surface].index.x;
  charge<Real>(Operation::load, 2);
  return before == k_void ? far : far / database.surfaces[before].index.x;
}

}  // namespace maquette::firmware
