#pragma once

#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/surface_map.hpp"

/// The cylinder of radius 1 around the z axis from z = -1 to z = 1, closed by discs.
/// Faces: 0 the top disc, 1 the bottom disc, 2 the side.
namespace maquette::firmware::cylinder {

inline constexpr std::uint8_t k_side = 2;

template <class Real>
int intersect(const Ray<Real>& ray, const Real* /*parameters*/, Hit<Real>* hits) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Vector<Real>& o = ray.origin;
  const Vector<Real>& d = ray.direction;
  Interval<Real> interval = whole_ray<Real>();
  if (!clip_slab(interval, o.z, d.z, 0)) {
    return 0;
  }
  const Real across = d.x * d.x + d.y * d.y;
  if (across > zero) {
    const Real inverse = one / across;
    const Real middle = -(o.x * d.x + o.y * d.y) * inverse;
    const Real x = o.x + d.x * middle;
    const Real y = o.y + d.y * middle;
    const Real rest = one - (x * x + y * y);
    if (!(rest > zero)) {
      return 0;
    }
    const Real half = square_root(rest * inverse);
    enter_at(interval, middle - half, k_side);
    leave_at(interval, middle + half, k_side);
  } else if (o.x * o.x + o.y * o.y > one) {
    return 0;
  }
  return hits_of(interval, hits);
}

template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* /*parameters*/) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  if (face != k_side) {
    const Real end = face == 0 ? one : -one;
    return {{point.x, point.y, end}, {zero, zero, end}};
  }
  const Real inverse = saturated_inverse(square_root(point.x * point.x + point.y * point.y));
  const Vector<Real> outward(point.x * inverse, point.y * inverse, zero);
  return {{outward.x, outward.y, larger(-one, smaller(point.z, one))}, outward};
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, -one}, {one, one, one}};
  return true;
}

/// By angle and height; the discs by x and y.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* /*parameters*/) {
  if (face != k_side) {
    return {from_edges(point.x), from_edges(point.y)};
  }
  return {turn_of(point.x, point.y), from_edges(point.z)};
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

}  // namespace maquette::firmware::cylinder
