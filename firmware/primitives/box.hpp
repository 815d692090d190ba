#pragma once

#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/surface_map.hpp"

/// The cube from -1 to 1 in x, y and z. Faces: 2 * axis for +1, 2 * axis + 1 for -1.
namespace maquette::firmware::box {

template <class Real>
int intersect(const Ray<Real>& ray, const Real* /*parameters*/, Hit<Real>* hits) {
  Interval<Real> interval = whole_ray<Real>();
  for (int axis = 0; axis < 3; ++axis) {
    if (!clip_slab(interval, ray.origin[axis], ray.direction[axis],
                   static_cast<std::uint8_t>(2 * axis)) ||
        !(interval.in < interval.out)) {
      return 0;
    }
  }
  return hits_of(interval, hits);
}

template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* /*parameters*/) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  FacePoint<Real> settled{point, {zero, zero, zero}};
  for (int axis = 0; axis < 3; ++axis) {
    settled.position[axis] = larger(-one, smaller(point[axis], one));
  }
  const Real side = (face % 2) == 0 ? one : -one;
  settled.position[face / 2] = side;
  settled.normal[face / 2] = side;
  return settled;
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, -one}, {one, one, one}};
  return true;
}

/// Each face as it is seen from outside, with z upwards; the top with y upwards, the bottom with y
/// downwards.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* /*parameters*/) {
  const bool is_positive = (face % 2) == 0;
  switch (face / 2) {
    case 0:
      return {from_edges(is_positive ? point.y : -point.y), from_edges(point.z)};
    case 1:
      return {from_edges(is_positive ? -point.x : point.x), from_edges(point.z)};
    default:
      return {from_edges(point.x), from_edges(is_positive ? point.y : -point.y)};
  }
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr SurfaceMap<Real> k_surface_map = surface_place<Real>;
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, convex_hit_limit<Real>, true};
  }
};

}  // namespace maquette::firmware::box
