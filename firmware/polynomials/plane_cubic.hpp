#pragma once

#include <cstddef>

#include "firmware/polynomials/real_roots.hpp"

/// Cubic Bezier sections in a plane, by pairs of coordinates: (x, y), or (r, z) in the half-plane
/// through an axis. The last point of a section is the first of the next.
namespace maquette::firmware {

/// Reals of a control point: its two coordinates.
inline constexpr std::ptrdiff_t k_point_reals = 2;

/// Reals from one section to the next: four points, the last of them shared.
inline constexpr std::ptrdiff_t k_section_stride = 3 * k_point_reals;

/// A cubic by its Bezier ordinates.
template <class Real>
struct Cubic {
  Real at[4];
};

/// The first coordinate as a function of u, or the second from the second real on.
template <class Real>
Cubic<Real> coordinate(const Real* points) {
  charge<Real>(Operation::load, 4);
  return {{points[0], points[2], points[4], points[6]}};
}

template <class Real>
ControlPolygon<Real> polygon_of(const Cubic<Real>& cubic) {
  return {3, {cubic.at[0], cubic.at[1], cubic.at[2], cubic.at[3]}};
}

template <class Real>
Polynomial<Real> polynomial_of(const Cubic<Real>& cubic) {
  return polynomial_of(polygon_of(cubic));
}

template <class Real>
Real value_at(const Cubic<Real>& cubic, Real u) {
  const Real v = constant<Real>(1) - u;
  const Real three = constant<Real>(3);
  const Real middle = three * (v * cubic.at[1] + u * cubic.at[2]);
  return v * (v * (v * cubic.at[0]) + u * middle) + u * (u * (u * cubic.at[3]));
}

/// The derivative with respect to u.
template <class Real>
Real change_at(const Cubic<Real>& cubic, Real u) {
  const Real v = constant<Real>(1) - u;
  const Real first = cubic.at[1] - cubic.at[0];
  const Real middle = cubic.at[2] - cubic.at[1];
  const Real last = cubic.at[3] - cubic.at[2];
  const Real two = constant<Real>(2);
  return constant<Real>(3) * (v * (v * first + two * (u * middle)) + u * (u * last));
}

template <class Real>
void bisect(const Cubic<Real>& cubic, Cubic<Real>& lower, Cubic<Real>& upper) {
  const Real half = constant<Real>(0.5);
  const Real first = half * (cubic.at[0] + cubic.at[1]);
  const Real middle = half * (cubic.at[1] + cubic.at[2]);
  const Real last = half * (cubic.at[2] + cubic.at[3]);
  const Real low = half * (first + middle);
  const Real high = half * (middle + last);
  const Real joint = half * (low + high);
  lower = {{cubic.at[0], first, low, joint}};
  upper = {{joint, high, last, cubic.at[3]}};
}

/// The product of a cubic and its derivative.
template <class Real>
Polynomial<Real> times_derivative(const Cubic<Real>& cubic) {
  const ControlPolygon<Real> polygon = polygon_of(cubic);
  return product(polynomial_of(polygon), polynomial_of(derivative(polygon)));
}

/// The parameter of the point of the section nearest to (x, y): a root of the derivative of the
/// squared distance, of degree 5, or an end.
template <class Real>
Real nearest_parameter(const Real* points, Real x, Real y) {
  Cubic<Real> apart_x = coordinate(points);
  Cubic<Real> apart_y = coordinate(points + 1);
  for (int i = 0; i < 4; ++i) {
    apart_x.at[i] -= x;
    apart_y.at[i] -= y;
  }
  Polynomial<Real> change = times_derivative(apart_x);
  const Polynomial<Real> of_second = times_derivative(apart_y);
  for (int i = 0; i <= change.degree; ++i) {
    change.terms[i] += of_second.terms[i];
  }
  const auto distance_squared = [&](Real u) {
    const Real dx = value_at(apart_x, u);
    const Real dy = value_at(apart_y, u);
    return dx * dx + dy * dy;
  };
  const RealRoots<Real> roots = roots_of(change);
  Real best = constant<Real>(0);
  Real least = distance_squared(best);
  for (int i = 0; i <= roots.count; ++i) {
    const Real u = i < roots.count ? roots.at[i] : constant<Real>(1);
    const Real distance = distance_squared(u);
    if (distance < least) {
      least = distance;
      best = u;
    }
  }
  return best;
}

/// The curve at a parameter.
template <class Real>
struct CurvePoint {
  Real x;
  Real y;
  Real change_x;  ///< direction of the curve there; not zero unless the section is a point
  Real change_y;
};

template <class Real>
CurvePoint<Real> curve_point(const Real* points, Real u) {
  const Cubic<Real> x = coordinate(points);
  const Cubic<Real> y = coordinate(points + 1);
  CurvePoint<Real> point;
  point.x = value_at(x, u);
  point.y = value_at(y, u);
  point.change_x = change_at(x, u);
  point.change_y = change_at(y, u);
  if (sign_of(point.change_x) == 0 && sign_of(point.change_y) == 0) {
    // A cusp, or control points that fall together: the chord serves.
    point.change_x = points[6] - points[0];
    point.change_y = points[7] - points[1];
  }
  return point;
}

}  // namespace maquette::firmware
