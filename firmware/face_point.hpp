#pragma once

#include "firmware/crossing.hpp"
#include "firmware/projection.hpp"
#include "firmware/ray_query.hpp"

/// Rays in the local frames of leaves, and the points of faces that they meet.
namespace maquette::firmware {

/// The ray in the local frame of a leaf; distances along it stay the same.
template <Projection projection, class Real>
Ray<Real> local_ray(const PreparedLeaf<Real>& leaf, const RayQuery<Real>& query) {
  if constexpr (projection == Projection::perspective) {
    if (query.is_primary) {
      charge<Real>(Operation::load, 3);
      // It starts at the eye, and its direction is one unit deep.
      const Affine<Real>& frame = leaf.from_screen;
      const Vector<Real>& d = query.ray.direction;
      charge<Real>(Operation::load, 9);
      return {frame[3], frame[0] * d.x + frame[1] * d.y + frame[2]};
    }
  }
  return {transform_point(leaf.from_screen, query.ray.origin),
          transform_direction(leaf.from_screen, query.ray.direction)};
}

/// Computed in the leaf's frame, where it is settled on the face, and brought back.
template <Projection projection, class Real>
[[gnu::always_inline]] inline FacePoint<Real> settled_point(const Frame<Real>& frame,
                                                            const RayQuery<Real>& query,
                                                            const Crossing<Real>& crossing) {
  charge<Real>(Operation::point);
  const Leaf<Real>& leaf = frame.database.leaves[crossing.leaf];
  const PreparedLeaf<Real>& prepared = frame.prepared.leaves[crossing.leaf];
  const Primitive<Real>& primitive = primitive_of<Real>(leaf.kind);
  const Real* parameters = frame.database.parameters + leaf.first_parameter;
  charge<Real>(Operation::load, 3);
  const Ray<Real> local = local_ray<projection>(prepared, query);
  const FacePoint<Real> settled = primitive.settle(
      local.origin + local.direction * crossing.distance, crossing.face, parameters);
  return {transform_point(prepared.to_screen, settled.position),
          normalize(transform_normal(prepared.from_screen, settled.normal))};
}

/// The point of a crossing and the outward normal of unit length there, in the screen frame.
template <class Real>
[[gnu::noinline]] FacePoint<Real> face_point(const Frame<Real>& frame, const RayQuery<Real>& query,
                                             const Crossing<Real>& crossing) {
  const InFunction<Real> here(Function::points);
  return is_parallel(frame.database)
             ? settled_point<Projection::parallel>(frame, query, crossing)
             : settled_point<Projection::perspective>(frame, query, crossing);
}

}  // namespace maquette::firmware
