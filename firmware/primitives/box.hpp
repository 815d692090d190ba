#pragma once

#include "firmware/primitives/interval.hpp"

/// The cube from -1 to 1 in x, y and z. Faces: 2 * axis for +1, 2 * axis + 1 for -1.
namespace maquette::firmware::box {

template <class Real>
int intersect(const Ray<Real>& ray, const Real* /*parameters*/, Hit<Real>* hits) {
  Interval<Real> interval = whole_ray<Real>();
  for (int axis = 0; axis < 3; ++axis) {
    charge<Real>(Operation::loop);
    if (!clip_slab(interval, ray.origin[axis], ray.direction[axis],
                   static_cast<std::uint8_t>(2 * axis)) ||
        !(interval.in < interval.out)) {
      return 0;
    }
  }
  return hits_of(interval, hits);
}

template <class Real>
Vector<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* /*parameters*/) {
  const Real one = constant<Real>(1);
  Vector<Real> settled;
  for (int axis = 0; axis < 3; ++axis) {
    charge<Real>(Operation::loop);
    settled[axis] = larger(-one, smaller(point[axis], one));
  }
  settled[face / 2] = (face % 2) == 0 ? one : -one;
  return settled;
}

template <class Real>
Vector<Real> normal(const Vector<Real>& /*point*/, std::uint8_t face, const Real* /*parameters*/) {
  const Real zero = constant<Real>(0);
  Vector<Real> outward(zero, zero, zero);
  outward[face / 2] = (face % 2) == 0 ? constant<Real>(1) : constant<Real>(-1);
  return outward;
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, -one}, {one, one, one}};
  return true;
}

}  // namespace maquette::firmware::box
