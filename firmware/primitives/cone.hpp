#pragma once

#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/surface_map.hpp"

/// The cone x^2 + y^2 <= z^2 between z = top and z = 1, closed by discs; top, its only parameter,
/// is 0 for a pointed cone and less than 1. Faces: 0 the base z = 1, 1 the top, 2 the side.
namespace maquette::firmware::cone {

inline constexpr std::uint8_t k_side = 2;

/// Coefficients of x^2 + y^2 - z^2 = a s^2 + 2 b s + c along a ray, with s = t - base. The base is
/// near the primitive so that c does not cancel when the origin is far away.
template <class Real>
struct SideEquation {
  Real base;
  Real a;
  Real b;
  Real c;
  Real discriminant;
};

template <class Real>
SideEquation<Real> side_equation(const Ray<Real>& ray, Real slab_entry) {
  const Real zero = constant<Real>(0);
  const Vector<Real>& o = ray.origin;
  const Vector<Real>& d = ray.direction;
  const Real across = d.x * d.x + d.y * d.y;
  const Real along = d.z * d.z;
  SideEquation<Real> equation;
  equation.a = across - along;
  const bool steep = equation.a < zero;
  equation.base = steep ? slab_entry : -(o.x * d.x + o.y * d.y) / across;
  const Vector<Real> p = o + d * equation.base;
  const Real radius_squared = p.x * p.x + p.y * p.y;
  equation.c = radius_squared - p.z * p.z;
  if (steep) {
    equation.b = p.x * d.x + p.y * d.y - p.z * d.z;
    equation.discriminant = equation.b * equation.b - equation.a * equation.c;
  } else {
    // The base is the point nearest to the axis: p is perpendicular to d in x and y.
    equation.b = -(p.z * d.z);
    equation.discriminant = across * (p.z * p.z) - equation.a * radius_squared;
  }
  return equation;
}

/// Narrows to the part inside the side; returns false when there is none.
template <class Real>
bool clip_side(Interval<Real>& interval, const SideEquation<Real>& equation, bool upwards) {
  const Real zero = constant<Real>(0);
  const bool steep = equation.a < zero;
  if (!(equation.discriminant > zero) && !steep) {
    return false;
  }
  const Real root = square_root(larger(equation.discriminant, zero));
  const Real q = equation.b < zero ? root - equation.b : -(equation.b + root);
  const Real far = far_away<Real>();
  Real first;
  if (absolute(equation.a) * far > absolute(q)) {
    first = q / equation.a;
  } else {
    // Parallel to a generatrix: one side of the quotient's infinity.
    first = (q < zero) == steep ? far : -far;
  }
  const Real second = absolute(q) > zero ? equation.c / q : zero;
  const Real low = equation.base + smaller(first, second);
  const Real high = equation.base + larger(first, second);
  if (!steep) {
    enter_at(interval, low, k_side);
    leave_at(interval, high, k_side);
  } else if (upwards) {
    // A steep ray meets the lower nappe first; the primitive lies on the upper one.
    enter_at(interval, high, k_side);
  } else {
    leave_at(interval, low, k_side);
  }
  return true;
}

template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const Real zero = constant<Real>(0);
  const Real top = parameters[0];
  charge<Real>(Operation::load);
  const Real z = ray.origin.z;
  const Real direction = ray.direction.z;
  Interval<Real> interval = whole_ray<Real>();
  if (!clip_above(interval, z, direction, constant<Real>(1), 0) ||
      !clip_above(interval, -z, -direction, -top, 1)) {
    return 0;
  }
  if (!clip_side(interval, side_equation(ray, interval.in), direction > zero)) {
    return 0;
  }
  return hits_of(interval, hits);
}

/// The apex has no normal; the axis serves.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Real top = parameters[0];
  if (face != k_side) {
    return {{point.x, point.y, face == 0 ? one : top},
            {zero, zero, face == 0 ? one : constant<Real>(-1)}};
  }
  const Real z = larger(top, smaller(point.z, one));
  const Real radius = square_root(point.x * point.x + point.y * point.y);
  const Real ratio = radius > zero ? z / radius : zero;
  const Vector<Real> settled(point.x * ratio, point.y * ratio, z);
  if (!(z > zero)) {
    return {settled, {zero, zero, constant<Real>(-1)}};
  }
  return {settled, {settled.x, settled.y, -z}};
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, parameters[0]}, {one, one, one}};
  return true;
}

/// By angle and height; the discs by x and y, as far as the base reaches.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* parameters) {
  if (face != k_side) {
    return {from_edges(point.x), from_edges(point.y)};
  }
  const Real top = parameters[0];
  charge<Real>(Operation::load);
  return {turn_of(point.x, point.y), within_unit((point.z - top) / (constant<Real>(1) - top))};
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

}  // namespace maquette::firmware::cone
