#pragma once

#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/surface_map.hpp"

/// The unit sphere; ellipsoids come from the local frame.
namespace maquette::firmware::sphere {

/// From the point of the ray nearest to the centre, where no large numbers cancel.
template <class Real>
int intersect(const Ray<Real>& ray, const Real* /*parameters*/, Hit<Real>* hits) {
  const Real inverse = constant<Real>(1) / glm::dot(ray.direction, ray.direction);
  const Real middle = -glm::dot(ray.origin, ray.direction) * inverse;
  const Vector<Real> nearest = ray.origin + ray.direction * middle;
  const Real rest = constant<Real>(1) - glm::dot(nearest, nearest);
  if (!(rest > constant<Real>(0))) {
    return 0;
  }
  const Real half = square_root(rest * inverse);
  return hits_of<Real>({middle - half, middle + half, 0, 0}, hits);
}

template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t /*face*/,
                       const Real* /*parameters*/) {
  const Vector<Real> settled = normalize(point);
  return {settled, settled};
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, -one}, {one, one, one}};
  return true;
}

/// By longitude and latitude.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t /*face*/,
                                 const Real* /*parameters*/) {
  const Real height = smaller(constant<Real>(1), absolute(point.z));
  const Real from_pole = arc_cosine(height) * constant<Real>(1 / elementary::k_pi);
  return {turn_of(point.x, point.y),
          within_unit(point.z > constant<Real>(0) ? constant<Real>(1) - from_pole : from_pole)};
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

}  // namespace maquette::firmware::sphere

namespace maquette::firmware {

template <>
inline constexpr bool k_fits_unit_ball<sphere::Kind> = true;

}  // namespace maquette::firmware
