#pragma once

#include "firmware/polynomials/plane_cubic.hpp"
#include "firmware/polynomials/real_roots.hpp"
#include "firmware/primitives/primitive.hpp"

/// One cubic section of a surface of revolution about the z axis: x^2 + y^2 = r(u)^2, z = z(u) for
/// 0 <= u <= 1 (paper, section IV.2.3).
namespace maquette::firmware::revolution {

/// Degree of a section's equation: the most hits that it gives.
inline constexpr int k_section_degree = 6;

/// Rays whose direction is within so many ulps of perpendicular to the axis stay at one height
/// within the rounding of their points.
inline constexpr double k_level_tolerance = 4;

/// A ray as the axis sees it. Way is counted along the ray's image on the plane z = 0, from its
/// point nearest to the axis; the ray is at height + slope * s, way + across * s for s from the
/// point nearest to the origin, where no large numbers cancel.
template <class Real>
struct AxialRay {
  Real base;  ///< distance of that point, in units of the local frame
  Real inverse_length;
  Real height;
  Real slope;
  Real way;
  Real across;
  Real passing;                         ///< distance from the axis to the line
  Real root_tolerance = ulps<Real>(1);  ///< of the parameters u of its hits

  /// In lengths of the ray's direction.
  [[nodiscard]] Real distance(Real s) const { return (base + s) * inverse_length; }
  /// Zero at the point of height z nearest to the axis; slope times the way.
  [[nodiscard]] Real scaled_way(Real z) const { return across * (z - height) + slope * way; }
  /// The two factors of slope^2 (r^2 - passing^2).
  [[nodiscard]] Real inner(Real r) const { return absolute(slope) * (r - passing); }
  [[nodiscard]] Real outer(Real r) const { return absolute(slope) * (r + passing); }
  /// Negative where the ray passes height z nearer to the axis than r.
  [[nodiscard]] Real outside_by(Real r, Real z) const {
    const Real at = scaled_way(z);
    return at * at - inner(r) * outer(r);
  }
  [[nodiscard]] bool is_level() const { return absolute(slope) <= ulps<Real>(k_level_tolerance); }
};

template <class Real>
AxialRay<Real> axial_ray(const Ray<Real>& ray) {
  AxialRay<Real> axial;
  axial.inverse_length = constant<Real>(1) / length(ray.direction);
  const Vector<Real> unit = ray.direction * axial.inverse_length;
  axial.base = -glm::dot(ray.origin, unit);
  const Vector<Real> nearest = ray.origin + unit * axial.base;
  axial.height = nearest.z;
  axial.slope = unit.z;
  axial.across = square_root(unit.x * unit.x + unit.y * unit.y);
  if (axial.across > constant<Real>(0)) {
    const Real inverse = constant<Real>(1) / axial.across;
    const Real x = unit.x * inverse;
    const Real y = unit.y * inverse;
    axial.way = nearest.x * x + nearest.y * y;
    axial.passing = absolute(nearest.x * y - nearest.y * x);
  } else {
    axial.way = constant<Real>(0);
    axial.passing = square_root(nearest.x * nearest.x + nearest.y * nearest.y);
  }
  return axial;
}

/// The equation of degree 6 in u, by its cubic factors: way^2 - inner outer, all times slope^2, so
/// that no division is needed. Bisected as the factors, it keeps its accuracy where both terms are
/// small: for rays nearly perpendicular to the axis.
template <class Real>
struct SectionCurve {
  Cubic<Real> way;
  Cubic<Real> inner;
  Cubic<Real> outer;
};

template <class Real>
SectionCurve<Real> section_curve(const AxialRay<Real>& ray, const Real* points) {
  SectionCurve<Real> curve;
  for (int i = 0; i < 4; ++i) {
    charge<Real>(Operation::load, 2);
    const Real* point = points + i * k_point_reals;
    curve.inner.at[i] = ray.inner(point[0]);
    curve.outer.at[i] = ray.outer(point[0]);
    curve.way.at[i] = ray.scaled_way(point[1]);
  }
  return curve;
}

template <class Real>
Polynomial<Real> polynomial_of(const SectionCurve<Real>& curve) {
  const Real two = constant<Real>(2);
  const Real three = constant<Real>(3);
  const auto* a = curve.way.at;
  const auto* b = curve.inner.at;
  const auto* c = curve.outer.at;
  const Real a1 = three * a[1];
  const Real a2 = three * a[2];
  const Real b1 = three * b[1];
  const Real b2 = three * b[2];
  const Real c1 = three * c[1];
  const Real c2 = three * c[2];
  return {6,
          {a[0] * a[0] - b[0] * c[0], two * (a[0] * a1) - (b[0] * c1 + b1 * c[0]),
           (two * (a[0] * a2) + a1 * a1) - (b[0] * c2 + b1 * c1 + b2 * c[0]),
           two * (a[0] * a[3] + a1 * a2) - ((b[0] * c[3] + b[3] * c[0]) + (b1 * c2 + b2 * c1)),
           (two * (a1 * a[3]) + a2 * a2) - (b1 * c[3] + b2 * c2 + b[3] * c1),
           two * (a2 * a[3]) - (b2 * c[3] + b[3] * c2), a[3] * a[3] - b[3] * c[3]}};
}

template <class Real>
void bisect(const SectionCurve<Real>& curve, SectionCurve<Real>& lower, SectionCurve<Real>& upper) {
  bisect(curve.way, lower.way, upper.way);
  bisect(curve.inner, lower.inner, upper.inner);
  bisect(curve.outer, lower.outer, upper.outer);
}

/// Half of the chord that the line cuts out of the circle of radius r, seen along the axis.
template <class Real>
Real half_chord_squared(const AxialRay<Real>& ray, Real r) {
  return larger(constant<Real>(0), (r - ray.passing) * (r + ray.passing));
}

/// Where the ray meets the circle of parameter u: from its height or from its radius, whichever
/// rounding disturbs less. The side of the axis comes from the cubic that was solved, which rounds
/// less than the height.
template <class Real>
Real place_at(const AxialRay<Real>& ray, const SectionCurve<Real>& curve, const Real* points,
              Real u) {
  const Real r = value_at(coordinate(points), u);
  const Real chord_squared = half_chord_squared(ray, r);
  const Real steep = ray.slope * r;
  if (steep * steep > chord_squared * (ray.across * ray.across)) {
    return (value_at(coordinate(points + 1), u) - ray.height) / ray.slope;
  }
  const Real chord = square_root(chord_squared);
  const Real zero = constant<Real>(0);
  const bool beyond = (value_at(curve.way, u) < zero) == (ray.slope < zero);
  return ((beyond ? chord : -chord) - ray.way) / ray.across;
}

/// Calls `visit(distance, is_far, change)` with the hits of a ray that keeps its height: both meet
/// the section at one u, or neither. `change` is that of the way with u.
template <class Real, class Visit>
[[gnu::always_inline]] inline void visit_level(const AxialRay<Real>& ray, const Real* points,
                                               Visit visit) {
  const Cubic<Real> radius = coordinate(points);
  Cubic<Real> way = coordinate(points + 1);
  for (Real& ordinate : way.at) {
    ordinate = ray.scaled_way(ordinate);
  }
  const RealRoots<Real> roots =
      roots_of(firmware::polynomial_of(polygon_of(way)), ray.root_tolerance);
  for (int i = 0; i < roots.count; ++i) {
    const Real u = roots.at[i];
    const Real r = value_at(radius, u);
    if (!(r > ray.passing)) {
      continue;
    }
    // The little that the height changes up to either hit moves u, to first order.
    const Real chord = square_root(half_chord_squared(ray, r));
    const Real change = change_at(way, u);
    const Real widening = change_at(radius, u) * r * ray.slope;
    const Real tilt =
        absolute(change) * chord > absolute(widening) ? widening / change : constant<Real>(0);
    const Real inverse = constant<Real>(1) / ray.across;
    visit(ray.distance((tilt - chord - ray.way) * inverse), false, change);
    visit(ray.distance((tilt + chord - ray.way) * inverse), true, change);
  }
}

template <class Real>
int intersect_level(const AxialRay<Real>& ray, const Real* points, std::uint8_t face,
                    Hit<Real>* hits) {
  int count = 0;
  visit_level(ray, points, [&](Real distance, bool /*is_far*/, Real /*change*/) {
    hits[count++] = {distance, face};
  });
  return count;
}

/// Writes the hits of a ray on a section, in no order; returns their number.
template <class Real>
int intersect_section(const AxialRay<Real>& ray, const Real* points, std::uint8_t face,
                      Hit<Real>* hits) {
  if (ray.is_level()) {
    return intersect_level(ray, points, face, hits);
  }
  const SectionCurve<Real> curve = section_curve(ray, points);
  const RealRoots<Real> roots = roots_of_curve<Real>(curve, k_section_degree, ray.root_tolerance);
  for (int i = 0; i < roots.count; ++i) {
    hits[i] = {ray.distance(place_at(ray, curve, points, roots.at[i])), face};
  }
  return roots.count;
}

}  // namespace maquette::firmware::revolution
