#pragma once

#include "firmware/polynomials/plane_cubic.hpp"
#include "firmware/primitives/primitive.hpp"

/// The outline of a prism in the plane of x and y: closed contours of straight and cubic edges,
/// filled where a line from outside has crossed an odd number of them.
///
/// Parameters: number of straight edges; number of cubic edges; the extents of a balanced binary
/// tree over the edges, each node before its children; the two points of every straight edge; the
/// four of every cubic one. Every edge has the solid on its left.
namespace maquette::firmware::prism {

inline constexpr std::ptrdiff_t k_header_reals = 2;
inline constexpr std::ptrdiff_t k_extent_reals = 4;
inline constexpr std::ptrdiff_t k_line_reals = 2 * k_point_reals;
inline constexpr std::ptrdiff_t k_cubic_reals = 4 * k_point_reals;

/// Crossings of a line with an outline, of which a straight edge gives one and a cubic one three.
inline constexpr int k_crossing_limit = 254;
inline constexpr int k_tree_height = 8;  ///< of the binary tree over so many edges

constexpr int crossing_count(int lines, int cubics) { return lines + 3 * cubics; }

constexpr std::ptrdiff_t parameter_count(int lines, int cubics) {
  return k_header_reals + (2 * (lines + cubics) - 1) * k_extent_reals + lines * k_line_reals +
         cubics * k_cubic_reals;
}

/// Around the points of a node's edges.
template <class Real>
struct PlaneExtent {
  Real low_x;
  Real high_x;
  Real low_y;
  Real high_y;
};

template <class Real>
struct Outline {
  int lines;
  int cubics;
  const Real* extents;
  const Real* points;

  [[nodiscard]] int edges() const { return lines + cubics; }
  [[nodiscard]] bool is_line(int edge) const { return edge < lines; }
  [[nodiscard]] const Real* edge(int number) const {
    return is_line(number) ? points + number * k_line_reals
                           : points + lines * k_line_reals + (number - lines) * k_cubic_reals;
  }
  [[nodiscard]] PlaneExtent<Real> extent(int node) const {
    const Real* at = extents + node * k_extent_reals;
    charge<Real>(Operation::load, 4);
    return {at[0], at[1], at[2], at[3]};
  }
};

template <class Real>
Outline<Real> outline(const Real* parameters) {
  charge<Real>(Operation::load, 2);
  Outline<Real> result;
  result.lines = to_integer(parameters[0]);
  result.cubics = to_integer(parameters[1]);
  result.extents = parameters + k_header_reals;
  result.points = result.extents + (2 * result.edges() - 1) * k_extent_reals;
  return result;
}

/// A ray's image on the plane. Way is counted along it from its point nearest to the origin, where
/// no large numbers cancel.
template <class Real>
struct PlaneRay {
  Real x;  ///< direction, of unit length
  Real y;
  Real passing;  ///< how far the line passes the origin; positive: on its left
  Real base;     ///< distance along the ray of that point
  Real inverse_length;

  /// Positive on the left; of the same sign for all edges that share a point, as it is the same
  /// number. Zero counts as positive.
  [[nodiscard]] Real side(Real px, Real py) const { return (x * py - y * px) - passing; }
  [[nodiscard]] Real way(Real px, Real py) const { return x * px + y * py; }
  [[nodiscard]] Real distance(Real at) const { return base + at * inverse_length; }
};

/// The direction must not be zero.
template <class Real>
PlaneRay<Real> plane_ray(Real origin_x, Real origin_y, Real direction_x, Real direction_y) {
  PlaneRay<Real> ray;
  ray.inverse_length =
      constant<Real>(1) / square_root(direction_x * direction_x + direction_y * direction_y);
  ray.x = direction_x * ray.inverse_length;
  ray.y = direction_y * ray.inverse_length;
  const Real way = -(origin_x * ray.x + origin_y * ray.y);
  const Real nearest_x = origin_x + ray.x * way;
  const Real nearest_y = origin_y + ray.y * way;
  ray.base = way * ray.inverse_length;
  ray.passing = ray.x * nearest_y - ray.y * nearest_x;
  return ray;
}

/// Whether all of a node lies on one side. Rounding keeps the order of the sides, so no edge is
/// left out whose ends are of different signs.
template <class Real>
bool misses(const PlaneRay<Real>& ray, const PlaneExtent<Real>& extent) {
  const Real zero = constant<Real>(0);
  const bool rightwards = ray.x > zero;
  const bool upwards = ray.y > zero;
  const Real least =
      ray.side(upwards ? extent.high_x : extent.low_x, rightwards ? extent.low_y : extent.high_y);
  const Real greatest =
      ray.side(upwards ? extent.low_x : extent.high_x, rightwards ? extent.high_y : extent.low_y);
  return least >= zero || greatest < zero;
}

template <class Real>
int cross_line(const PlaneRay<Real>& ray, const Real* points, std::uint8_t face, Hit<Real>* hit) {
  const Real zero = constant<Real>(0);
  charge<Real>(Operation::load, 4);
  const Real first = ray.side(points[0], points[1]);
  const Real last = ray.side(points[2], points[3]);
  if ((first < zero) == (last < zero)) {
    return 0;
  }
  const Real begin = ray.way(points[0], points[1]);
  const Real end = ray.way(points[2], points[3]);
  *hit = {ray.distance(begin + (end - begin) * (first / (first - last))), face};
  return 1;
}

template <class Real>
int cross_cubic(const PlaneRay<Real>& ray, const Real* points, std::uint8_t face, Hit<Real>* hits) {
  const Cubic<Real> x = coordinate(points);
  const Cubic<Real> y = coordinate(points + 1);
  Cubic<Real> side;
  for (int i = 0; i < 4; ++i) {
    side.at[i] = ray.side(x.at[i], y.at[i]);
  }
  const RealRoots<Real> roots = roots_of_curve<Real>(side, 3);
  for (int i = 0; i < roots.count; ++i) {
    const Real u = roots.at[i];
    hits[i] = {ray.distance(ray.way(value_at(x, u), value_at(y, u))), face};
  }
  return roots.count;
}

/// Writes the crossings of the edges below a node of the tree, in no order; returns their number.
template <class Real>
int cross_node(const PlaneRay<Real>& ray, const Outline<Real>& curve, int node, int first,
               int edges, Hit<Real>* hits) {
  charge<Real>(Operation::part);
  if (misses(ray, curve.extent(node))) {
    return 0;
  }
  if (edges == 1) {
    const auto face = static_cast<std::uint8_t>(first);
    return curve.is_line(first) ? cross_line(ray, curve.edge(first), face, hits)
                                : cross_cubic(ray, curve.edge(first), face, hits);
  }
  const int half = edges / 2;
  const int count = cross_node(ray, curve, node + 1, first, half, hits);
  return count + cross_node(ray, curve, node + 2 * half, first + half, edges - half, hits + count);
}

/// Writes the crossings of a line with the outline, in no order; returns their number, which is
/// even, as contours are closed.
template <class Real>
int cross_outline(const PlaneRay<Real>& ray, const Outline<Real>& curve, Hit<Real>* hits) {
  return cross_node(ray, curve, 0, 0, curve.edges(), hits);
}

/// A point on an edge and the edge's direction there.
template <class Real>
CurvePoint<Real> edge_point(const Outline<Real>& curve, int edge, Real x, Real y) {
  const Real* points = curve.edge(edge);
  if (!curve.is_line(edge)) {
    return curve_point(points, nearest_parameter(points, x, y));
  }
  charge<Real>(Operation::load, 4);
  const Real change_x = points[2] - points[0];
  const Real change_y = points[3] - points[1];
  const Real along = (x - points[0]) * change_x + (y - points[1]) * change_y;
  const Real u = along / (change_x * change_x + change_y * change_y);
  const Real share = larger(constant<Real>(0), smaller(u, constant<Real>(1)));
  return {points[0] + change_x * share, points[1] + change_y * share, change_x, change_y};
}

}  // namespace maquette::firmware::prism
