#pragma once

#include "firmware/primitives/interval.hpp"

/// The half-space z <= 0.
namespace maquette::firmware::half_space {

template <class Real>
int intersect(const Ray<Real>& ray, const Real* /*parameters*/, Hit<Real>* hits) {
  Interval<Real> interval = whole_ray<Real>();
  if (!clip_above(interval, ray.origin.z, ray.direction.z, constant<Real>(0), 0)) {
    return 0;
  }
  return hits_of(interval, hits);
}

template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t /*face*/,
                       const Real* /*parameters*/) {
  const Real zero = constant<Real>(0);
  return {{point.x, point.y, zero}, {zero, zero, constant<Real>(1)}};
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& /*box*/) {
  return false;
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, convex_hit_limit<Real>, true};
  }
};

}  // namespace maquette::firmware::half_space
