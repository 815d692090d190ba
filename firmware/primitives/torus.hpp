#pragma once

#include "firmware/polynomials/real_roots.hpp"
#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/surface_map.hpp"

/// The torus about the z axis whose outer radius is 1: points within `minor` of the circle of
/// radius 1 - minor in the plane z = 0. Its surface is one face.
///
/// Parameters: minor, above 0 and at most 1/2; tolerance of the roots that give a ray's hits, in
/// ulps.
namespace maquette::firmware::torus {

inline constexpr int k_degree = 4;
inline constexpr std::ptrdiff_t k_root_tolerance = 1;  ///< its place among the parameters

/// A ray by the distance s from its point nearest to the centre, where no large numbers cancel.
template <class Real>
struct CentralRay {
  Real base;  ///< distance of that point from the origin of the ray
  Real inverse_length;
  Vector<Real> nearest;
  Vector<Real> direction;  ///< of unit length

  [[nodiscard]] Vector<Real> at(Real s) const { return nearest + direction * s; }
  /// In lengths of the ray's direction.
  [[nodiscard]] Real distance(Real s) const { return (base + s) * inverse_length; }
};

template <class Real>
CentralRay<Real> central_ray(const Ray<Real>& ray) {
  CentralRay<Real> central;
  central.inverse_length = constant<Real>(1) / length(ray.direction);
  central.direction = ray.direction * central.inverse_length;
  central.base = -glm::dot(ray.origin, central.direction);
  central.nearest = ray.origin + central.direction * central.base;
  return central;
}

/// The part of a ray, in s, in the unit ball and between the planes that the torus touches; outside
/// of them there is none of it. Returns false when that is all of the ray.
template <class Real>
bool clip(Interval<Real>& interval, const CentralRay<Real>& ray, Real minor) {
  const Real rest = constant<Real>(1) - glm::dot(ray.nearest, ray.nearest);
  if (!(rest > constant<Real>(0))) {
    return false;
  }
  const Real half = square_root(rest);
  interval = {-half, half, 0, 0};
  return clip_above(interval, ray.nearest.z, ray.direction.z, minor, 0) &&
         clip_above(interval, -ray.nearest.z, -ray.direction.z, minor, 0) &&
         interval.in < interval.out;
}

/// A quadratic in Bernstein form, by terms as those of a Polynomial.
template <class Real>
struct Quadratic {
  Real terms[3];
};

/// factor * quadratic + added.
template <class Real>
Quadratic<Real> linear(const Quadratic<Real>& quadratic, Real factor, Real added) {
  const Real* terms = quadratic.terms;
  return {
      {factor * terms[0] + added, factor * terms[1] + (added + added), factor * terms[2] + added}};
}

/// a b + c d.
template <class Real>
Polynomial<Real> sum_of_products(const Quadratic<Real>& a, const Quadratic<Real>& b,
                                 const Quadratic<Real>& c, const Quadratic<Real>& d) {
  Polynomial<Real> sum;
  sum.degree = k_degree;
  for (Real& term : sum.terms) {
    term = constant<Real>(0);
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      charge<Real>(Operation::load, 4);
      sum.terms[i + k] += a.terms[i] * b.terms[k] + c.terms[i] * d.terms[k];
    }
  }
  return sum;
}

/// f = (hole^2 - r) (1 - r) + z^2 (2 (hole + r) + z^2), with r = x^2 + y^2, between two points of a
/// ray: negative inside, and a sum of products that are as small as f near the rim, whose radius is
/// 1, and near the hole, so that little is lost where an end is there.
template <class Real>
Polynomial<Real> along_chord(const Vector<Real>& low, const Vector<Real>& high, Real hole) {
  const Real one = constant<Real>(1);
  const Real two = constant<Real>(2);
  const Quadratic<Real> r{{low.x * low.x + low.y * low.y, two * (low.x * high.x + low.y * high.y),
                           high.x * high.x + high.y * high.y}};
  const Quadratic<Real> z{{low.z * low.z, two * (low.z * high.z), high.z * high.z}};
  Quadratic<Real> rest = linear(r, two, two * hole);
  for (int i = 0; i < 3; ++i) {
    rest.terms[i] += z.terms[i];
  }
  return sum_of_products(linear(r, -one, hole * hole), linear(r, -one, one), z, rest);
}

/// The roots of a chord from s = low to high, written from `hits` on; returns their number.
template <class Real>
int hits_of_chord(const CentralRay<Real>& ray, const Polynomial<Real>& along, Real tolerance,
                  Real low, Real high, Hit<Real>* hits) {
  const RealRoots<Real> roots = roots_of(along, tolerance * ulps<Real>(1));
  for (int i = 0; i < roots.count; ++i) {
    hits[i] = {ray.distance(smaller(low + (high - low) * roots.at[i], high)), 0};
  }
  return roots.count;
}

/// Where on its way the ray is nearest to the axis; the end of the way when that is elsewhere.
template <class Real>
Real nearest_to_axis(const CentralRay<Real>& ray, const Interval<Real>& way) {
  const Vector<Real>& d = ray.direction;
  const Real across = d.x * d.x + d.y * d.y;
  if (!(across > constant<Real>(0))) {
    return way.out;
  }
  // The direction is perpendicular to the way to the point nearest to the centre.
  const Real at = ray.nearest.z * d.z / across;
  return way.in < at && at < way.out ? at : way.out;
}

/// The way through the torus is one chord, or two that meet where the ray is nearest to the axis,
/// and maybe in the hole; they have that end of the same sign. The outer ends are outside: what
/// rounding makes of them is no less than zero.
template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const Real zero = constant<Real>(0);
  const Real minor = parameters[0];
  const Real tolerance = parameters[k_root_tolerance];
  const Real hole = constant<Real>(1) - (minor + minor);
  const CentralRay<Real> central = central_ray(ray);
  Interval<Real> way;
  charge<Real>(Operation::load, 2);
  if (!clip(way, central, minor)) {
    return 0;
  }
  const Real middle = nearest_to_axis(central, way);
  Polynomial<Real> along = along_chord(central.at(way.in), central.at(middle), hole);
  along.terms[0] = larger(along.terms[0], zero);
  Hit<Real> found[2 * k_degree];
  int count = 0;
  if (middle < way.out) {
    count = hits_of_chord(central, along, tolerance, way.in, middle, found);
    way.in = middle;
    along = along_chord(central.at(middle), central.at(way.out), hole);
  }
  along.terms[k_degree] = larger(along.terms[k_degree], zero);
  count += hits_of_chord(central, along, tolerance, way.in, way.out, found + count);
  // Where rounding makes more hits than a line has, the last two are left out.
  count = smaller(count, k_degree);
  for (int i = 0; i < count; ++i) {
    hits[i] = found[i];
  }
  return count;
}

/// Outwards from the nearest point of the tube's middle. On the axis every direction is as near, in
/// the middle every one as far outwards; one of them serves.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t /*face*/, const Real* parameters) {
  const Real zero = constant<Real>(0);
  const Real minor = parameters[0];
  const Real major = constant<Real>(1) - minor;
  const Real radius = square_root(point.x * point.x + point.y * point.y);
  charge<Real>(Operation::load);
  const Vector<Real> aside = radius > zero ? Vector<Real>(point.x / radius, point.y / radius, zero)
                                           : Vector<Real>(constant<Real>(1), zero, zero);
  const Vector<Real> off = aside * (radius - major) + Vector<Real>(zero, zero, point.z);
  const Real distance = length(off);
  const Vector<Real> outward = distance > zero ? off / distance : aside;
  return {aside * major + outward * minor, outward};
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const Real one = constant<Real>(1);
  const Real minor = parameters[0];
  charge<Real>(Operation::load);
  box = {{-one, -one, -minor}, {one, one, minor}};
  return true;
}

template <class Real>
int hit_limit(const Real* /*parameters*/) {
  return k_degree;
}

/// By the angle about the axis and that about the middle of the tube.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t /*face*/,
                                 const Real* parameters) {
  charge<Real>(Operation::load);
  const Real major = constant<Real>(1) - parameters[0];
  const Real radius = square_root(point.x * point.x + point.y * point.y);
  return {turn_of(point.x, point.y), turn_of(radius - major, point.z)};
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr SurfaceMap<Real> k_surface_map = surface_place<Real>;
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::torus
