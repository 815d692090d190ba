#pragma once

#include "firmware/primitives/hit_order.hpp"
#include "firmware/primitives/revolution_section.hpp"
#include "firmware/primitives/surface_map.hpp"

/// A solid of revolution about the z axis (paper, section IV): its generatrix is a chain of cubic
/// Bezier sections (r, z) with r >= 0 that has the solid on its left; where the chain is open,
/// discs at its ends close the solid. Faces: the sections by their numbers, then the first and the
/// last disc.
///
/// Parameters: number of sections; 1 if open, 0 if closed; tolerance of the roots that give a ray's
/// hits, in ulps; the extents of a balanced binary tree
/// over the sections, each node before its children; the control points, three for each section and
/// the last.
namespace maquette::firmware::revolution {

inline constexpr int k_section_limit = 32;
inline constexpr int k_tree_height = 5;  ///< of the binary tree over so many sections
inline constexpr int k_hit_limit = k_section_limit * k_section_degree + 2;
static_assert(k_hit_limit <= k_primitive_hit_limit);
inline constexpr std::uint8_t k_first_disc = k_section_limit;
inline constexpr std::uint8_t k_last_disc = k_section_limit + 1;
inline constexpr std::ptrdiff_t k_header_reals = 3;
inline constexpr std::ptrdiff_t k_root_tolerance = 2;  ///< its place among the parameters
inline constexpr std::ptrdiff_t k_extent_reals = 4;

/// Around the control points of a node's sections.
template <class Real>
struct RingExtent {
  Real low_z;
  Real high_z;
  Real low_r;
  Real high_r;
};

template <class Real>
struct Generatrix {
  int sections;
  bool is_open;
  const Real* extents;
  const Real* points;

  [[nodiscard]] const Real* section(int number) const { return points + number * k_section_stride; }
  [[nodiscard]] RingExtent<Real> extent(int node) const {
    const Real* at = extents + node * k_extent_reals;
    charge<Real>(Operation::load, 4);
    return {at[0], at[1], at[2], at[3]};
  }
};

template <class Real>
Generatrix<Real> generatrix(const Real* parameters) {
  charge<Real>(Operation::load, 2);
  Generatrix<Real> result;
  result.sections = to_integer(parameters[0]);
  result.is_open = parameters[1] > constant<Real>(0);
  result.extents = parameters + k_header_reals;
  result.points = result.extents + (2 * result.sections - 1) * k_extent_reals;
  return result;
}

/// Whether a ray certainly passes a node: beside its largest radius at all its heights, or through
/// its hole. Rounding keeps the order of the terms compared here and in the sections' equations, so
/// no section is left out whose ends are of different signs.
template <class Real>
bool misses(const AxialRay<Real>& ray, const RingExtent<Real>& extent) {
  const Real zero = constant<Real>(0);
  if (extent.high_r <= ray.passing) {
    return true;
  }
  const Real low = ray.scaled_way(extent.low_z);
  const Real high = ray.scaled_way(extent.high_z);
  const Real least = smaller(absolute(low), absolute(high));
  if ((low < zero) == (high < zero) &&
      least * least > ray.inner(extent.high_r) * ray.outer(extent.high_r)) {
    return true;
  }
  const Real most = larger(absolute(low), absolute(high));
  return extent.low_r > ray.passing &&
         most * most < ray.inner(extent.low_r) * ray.outer(extent.low_r);
}

/// Writes the hits of the sections below a node of the tree, in no order; returns their number.
template <class Real>
int intersect_node(const AxialRay<Real>& ray, const Generatrix<Real>& curve, int node, int first,
                   int sections, Hit<Real>* hits) {
  charge<Real>(Operation::part);
  if (misses(ray, curve.extent(node))) {
    return 0;
  }
  if (sections == 1) {
    return intersect_section(ray, curve.section(first), static_cast<std::uint8_t>(first), hits);
  }
  const int half = sections / 2;
  const int count = intersect_node(ray, curve, node + 1, first, half, hits);
  return count +
         intersect_node(ray, curve, node + 2 * half, first + half, sections - half, hits + count);
}

/// Adds the hit on a disc through the control point (r, z), where the ray passes nearer to the
/// axis. The same numbers tell whether the section that ends there is crossed once more.
template <class Real>
int intersect_disc(const AxialRay<Real>& ray, const Real* point, std::uint8_t face,
                   Hit<Real>* hit) {
  charge<Real>(Operation::load, 2);
  if (ray.is_level() || !(ray.outside_by(point[0], point[1]) < constant<Real>(0))) {
    return 0;
  }
  *hit = {ray.distance((point[1] - ray.height) / ray.slope), face};
  return 1;
}

template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const Generatrix<Real> curve = generatrix(parameters);
  AxialRay<Real> axial = axial_ray(ray);
  charge<Real>(Operation::load);
  axial.root_tolerance *= parameters[k_root_tolerance];
  int count = intersect_node(axial, curve, 0, 0, curve.sections, hits);
  if (curve.is_open) {
    count += intersect_disc(axial, curve.points, k_first_disc, hits + count);
    count += intersect_disc(axial, curve.section(curve.sections), k_last_disc, hits + count);
  }
  sort(hits, count);
  return count;
}

/// Distance from the axis.
template <class Real>
Real radius_of(const Vector<Real>& point) {
  return square_root(point.x * point.x + point.y * point.y);
}

/// The normal is perpendicular to the curve in the half-plane of the point (paper, section IV.2.3),
/// free of the quotient dr / dz; on the axis along the axis.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Generatrix<Real> curve = generatrix(parameters);
  if (face >= k_first_disc) {
    // With the solid on its left the chain runs from the lower side of the solid to the upper one.
    const bool is_first = face == k_first_disc;
    const Real height = curve.section(is_first ? 0 : curve.sections)[1];
    return {{point.x, point.y, height}, {zero, zero, is_first ? -one : one}};
  }
  const Real* points = curve.section(face);
  const Real radius = radius_of(point);
  const CurvePoint<Real> on = curve_point(points, nearest_parameter(points, radius, point.z));
  if (!(radius > zero)) {
    return {{zero, zero, on.y}, {zero, zero, on.change_x > zero ? -one : one}};
  }
  const Real inverse = one / radius;
  const Real x = point.x * inverse;
  const Real y = point.y * inverse;
  return {{x * on.x, y * on.x, on.y}, {x * on.change_y, y * on.change_y, -on.change_x}};
}

template <class Real>
int hit_limit(const Real* parameters) {
  return to_integer(parameters[0]) * k_section_degree + 2;
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const RingExtent<Real> extent = generatrix(parameters).extent(0);
  const Real r = extent.high_r;
  box = {{-r, -r, extent.low_z}, {r, r, extent.high_z}};
  return true;
}

/// By the angle and the parameter of the generatrix, whose sections share it evenly; the discs by x
/// and y as far as the solid reaches.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* parameters) {
  const Generatrix<Real> curve = generatrix(parameters);
  if (face >= k_first_disc) {
    const Real inverse = constant<Real>(1) / curve.extent(0).high_r;
    return {from_edges(point.x * inverse), from_edges(point.y * inverse)};
  }
  const Real along = nearest_parameter(curve.section(face), radius_of(point), point.z);
  return {turn_of(point.x, point.y),
          within_unit((from_integer<Real>(face) + along) / from_integer<Real>(curve.sections))};
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

}  // namespace maquette::firmware::revolution
