#pragma once

#include "firmware/primitives/algebraic_polynomial.hpp"
#include "firmware/primitives/interval.hpp"

/// The part f(x, y, z) <= 0 of the cube from -1 to 1, for a polynomial f of degree up to 8. Faces:
/// 0 the surface f = 0, then the cube's planes from 1 on, numbered as the box's.
///
/// Parameters: those of algebraic_polynomial.hpp, the largest coefficient of magnitude 1.
namespace maquette::firmware::algebraic {

inline constexpr std::uint8_t k_surface = 0;
inline constexpr std::uint8_t k_first_plane = 1;

/// Newton's steps from a point that rounding has moved off the surface: the second is for points
/// from far rays.
inline constexpr int k_settle_steps = 2;

/// Spacings below which a gradient is rounding: the point is taken as singular.
inline constexpr double k_gradient_tolerance = 8;

/// How far beside a singular point its sides are told apart, as a square, in ulps: f is of
/// second order there.
inline constexpr double k_singular_step_squared = 256;

/// The ray's part in the cube; returns false when there is none.
template <class Real>
bool clip_cube(Interval<Real>& interval, const Ray<Real>& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!clip_slab(interval, ray.origin[axis], ray.direction[axis],
                   static_cast<std::uint8_t>(k_first_plane + 2 * axis)) ||
        !(interval.in < interval.out)) {
      return false;
    }
  }
  return true;
}

/// Where the ends of the chord are of different signs its roots are odd in number, where they are
/// not even; so an end inside the surface, and no other, is a hit.
template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  Interval<Real> interval = whole_ray<Real>();
  if (!clip_cube(interval, ray)) {
    return 0;
  }
  const Polynomial<Real> along =
      along_chord(parameters, Vector<Real>(ray.origin + ray.direction * interval.in),
                  Vector<Real>(ray.origin + ray.direction * interval.out));
  const RealRoots<Real> roots = roots_of(along);
  const Real width = interval.out - interval.in;
  int count = 0;
  if (sign_of(along.terms[0]) < 0) {
    hits[count++] = {interval.in, interval.in_face};
  }
  for (int i = 0; i < roots.count; ++i) {
    hits[count++] = {smaller(interval.in + width * roots.at[i], interval.out), k_surface};
  }
  if (sign_of(along.terms[along.degree]) < 0) {
    hits[count++] = {interval.out, interval.out_face};
  }
  return count;
}

/// Outwards from a plane of the cube.
template <class Real>
Vector<Real> axis_direction(int plane) {
  const Real zero = constant<Real>(0);
  Vector<Real> direction(zero, zero, zero);
  direction[plane / 2] = plane % 2 == 0 ? constant<Real>(1) : constant<Real>(-1);
  return direction;
}

/// The point of the cube nearest to a point.
template <class Real>
Vector<Real> into_cube(const Vector<Real>& point) {
  const Real one = constant<Real>(1);
  Vector<Real> result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = larger(-one, smaller(point[axis], one));
  }
  return result;
}

/// At a singular point: of the six directions along the axes the one in which f is greatest.
template <class Real>
Vector<Real> singular_normal(const Vector<Real>& point, const Real* parameters) {
  const Real step = square_root(ulps<Real>(k_singular_step_squared));
  Vector<Real> best = axis_direction<Real>(0);
  Real greatest = -far_away<Real>();
  for (int plane = 0; plane < 6; ++plane) {
    const Vector<Real> direction = axis_direction<Real>(plane);
    const Vector<Real> beside = point + direction * step;
    const Real value = jet_at(parameters, beside).value;
    if (value > greatest) {
      greatest = value;
      best = direction;
    }
  }
  return best;
}

/// On the surface by Newton's steps along the gradient, taken as long as they bring f nearer to
/// zero; the gradient is the normal.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const Real zero = constant<Real>(0);
  Vector<Real> settled = into_cube(point);
  if (face != k_surface) {
    const Vector<Real> outward = axis_direction<Real>(face - k_first_plane);
    const int axis = (face - k_first_plane) / 2;
    settled[axis] = outward[axis];
    return {settled, outward};
  }
  Jet<Real> jet = jet_at(parameters, settled);
  for (int step = 0; step < k_settle_steps; ++step) {
    const Real steepness = glm::dot(jet.gradient, jet.gradient);
    if (!(steepness > zero)) {
      break;
    }
    const Vector<Real> next =
        into_cube(Vector<Real>(settled - jet.gradient * (jet.value / steepness)));
    const Jet<Real> next_jet = jet_at(parameters, next);
    if (!(absolute(next_jet.value) < absolute(jet.value))) {
      break;
    }
    settled = next;
    jet = next_jet;
  }
  const bool is_regular = magnitude(jet.gradient) > ulps<Real>(k_gradient_tolerance);
  return {settled, is_regular ? jet.gradient : singular_normal(settled, parameters)};
}

template <class Real>
bool bounds(const Real* /*parameters*/, Box<Real>& box) {
  const Real one = constant<Real>(1);
  box = {{-one, -one, -one}, {one, one, one}};
  return true;
}

/// All roots and, where both ends are inside, the ends.
template <class Real>
int hit_limit(const Real* parameters) {
  return (to_integer(parameters[0]) / 2 + 1) * 2;
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::algebraic
