#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/polynomials/plane_cubic.hpp"

/// Strip trees of curves (Ballard 1981), by which Kajiya (1983) intersects surfaces of revolution
/// and which the paper does without (section IV.1), to tell what making one takes. No board has it.
namespace maquette::firmware::strip_tree {

/// More levels no curve gets.
inline constexpr int k_level_limit = 24;

/// A rectangle along the chord of a piece of the curve, which holds the piece.
template <class Real>
struct Strip {
  Real begin[2];      ///< of the chord
  Real direction[2];  ///< of the chord, unit vector
  Real low_along;
  Real high_along;
  Real low_across;
  Real high_across;
};
inline constexpr int k_strip_reals = 8;

/// The strip of a piece from its Bezier points, `count` pairs of coordinates.
template <class Real>
Strip<Real> strip_of(const Real* points, int count) {
  const Real zero = constant<Real>(0);
  const Real* const last = points + (count - 1) * k_point_reals;
  charge<Real>(Operation::load, 4);
  const Real x = last[0] - points[0];
  const Real y = last[1] - points[1];
  const Real length = square_root(x * x + y * y);
  Strip<Real> strip{{points[0], points[1]}, {constant<Real>(1), zero}, zero, length, zero, zero};
  if (length > zero) {
    const Real inverse = constant<Real>(1) / length;
    strip.direction[0] = x * inverse;
    strip.direction[1] = y * inverse;
  }
  for (int i = 1; i < count - 1; ++i) {
    charge<Real>(Operation::load, 2);
    const Real dx = points[i * k_point_reals] - points[0];
    const Real dy = points[i * k_point_reals + 1] - points[1];
    const Real along = dx * strip.direction[0] + dy * strip.direction[1];
    const Real across = dy * strip.direction[0] - dx * strip.direction[1];
    strip.low_along = smaller(strip.low_along, along);
    strip.high_along = larger(strip.high_along, along);
    strip.low_across = smaller(strip.low_across, across);
    strip.high_across = larger(strip.high_across, across);
  }
  return strip;
}

/// Makes the strips of a section and of its halves, until a strip is no wider than `tolerance`;
/// calls `keep(strip, level)` with each. Returns the deepest level.
template <class Real, class Keep>
int divide(const Cubic<Real>& x, const Cubic<Real>& y, Real tolerance, int level, Keep& keep) {
  const Real points[] = {x.at[0], y.at[0], x.at[1], y.at[1], x.at[2], y.at[2], x.at[3], y.at[3]};
  const Strip<Real> strip = strip_of(points, 4);
  keep(strip, level);
  if (strip.high_across - strip.low_across <= tolerance || level >= k_level_limit) {
    return level;
  }
  Cubic<Real> lower[2];
  Cubic<Real> upper[2];
  bisect(x, lower[0], upper[0]);
  bisect(y, lower[1], upper[1]);
  const int below = divide(lower[0], lower[1], tolerance, level + 1, keep);
  const int above = divide(upper[0], upper[1], tolerance, level + 1, keep);
  return below > above ? below : above;
}

/// Makes the strip tree of a chain of Bezier sections, three points for each and the last: a
/// balanced one over the sections, and below it their halves. Returns the deepest level; the root
/// is level 0.
template <class Real, class Keep>
int build(const Real* points, int sections, Real tolerance, Keep& keep, int level = 0) {
  if (sections == 1) {
    return divide(coordinate(points), coordinate(points + 1), tolerance, level, keep);
  }
  keep(strip_of(points, 3 * sections + 1), level);
  const int half = sections / 2;
  const int below = build(points, half, tolerance, keep, level + 1);
  const int above =
      build(points + half * k_section_stride, sections - half, tolerance, keep, level + 1);
  return below > above ? below : above;
}

}  // namespace maquette::firmware::strip_tree
