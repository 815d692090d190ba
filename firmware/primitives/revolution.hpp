#pragma once

#include "firmware/primitives/generatrix_conversion.hpp"
#include "firmware/primitives/hit_list.hpp"
#include "firmware/primitives/revolution_faces.hpp"
#include "firmware/primitives/revolution_section.hpp"
#include "firmware/primitives/surface_map.hpp"

/// A solid of revolution about the z axis (paper, section IV): its generatrix is a chain of cubic
/// Bezier sections (r, z) with r >= 0 that has the solid on its left; where the chain is open,
/// discs at its ends close the solid (revolution_faces.hpp). The parameters are those of a
/// generatrix (generatrix.hpp), which boards make of its control points. Its sections are the
/// leaves of a binary tree whose nodes unite their surfaces (the paper's operator +S).
namespace maquette::firmware::revolution {

/// Of the binary tree over the sections: how deep functions may call themselves. So many sections
/// take 4 MB of a board's RAM.
inline constexpr int k_tree_height = 16;
inline constexpr int k_section_limit = 1 << k_tree_height;

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

/// A ray on its way through the tree of a generatrix.
template <class Real>
struct TreeWalk {
  AxialRay<Real> ray;
  Generatrix<Real> curve;
  HitList<Real> list;
};

/// How hits of a solid's section are added.
struct SolidSection {
  template <class Real>
  [[gnu::always_inline]] static void add_hits(TreeWalk<Real>& walk, int section) {
    HitList<Real>& list = walk.list;
    make_room(list, k_section_degree);
    list.count += intersect_section(walk.ray, walk.curve.section(section), face_of(section),
                                    list.hits + list.count);
  }
};

/// Adds the hits of the sections below a node, of which `first` is the first.
template <class Section, class Real>
void intersect_node(TreeWalk<Real>& walk, int node, int first, int sections) {
  charge<Real>(Operation::part);
  while (!misses(walk.ray, walk.curve.extent(node))) {
    if (sections == 1) {
      Section::add_hits(walk, first);
      return;
    }
    const int half = sections / 2;
    intersect_node<Section>(walk, node + 1, first, half);
    charge<Real>(Operation::part);
    node += 2 * half;
    first += half;
    sections -= half;
  }
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
  TreeWalk<Real> walk{axial_ray(ray), generatrix(parameters), hit_list(hits)};
  const AxialRay<Real>& axial = walk.ray;
  const Generatrix<Real>& curve = walk.curve;
  charge<Real>(Operation::load);
  walk.ray.root_tolerance *= parameters[k_root_tolerance];
  intersect_node<SolidSection>(walk, 0, 0, curve.sections);
  HitList<Real>& list = walk.list;
  if (curve.is_open) {
    make_room(list, 2);
    list.count += intersect_disc(axial, curve.points, k_first_disc, hits + list.count);
    list.count +=
        intersect_disc(axial, curve.section(curve.sections), k_last_disc, hits + list.count);
  }
  return in_order(list);
}

/// A point brought onto a section. The normal is perpendicular to the curve in the half-plane of
/// the point (paper, section IV.2.3), free of the quotient dr / dz; on the axis along the axis.
template <class Real>
[[gnu::always_inline]] inline FacePoint<Real> settled_on(const Real* section,
                                                         const Vector<Real>& point, Real radius) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const CurvePoint<Real> on = curve_point(section, nearest_parameter(section, radius, point.z));
  if (!(radius > zero)) {
    return {{zero, zero, on.y}, {zero, zero, on.change_x > zero ? -one : one}};
  }
  const Real inverse = one / radius;
  const Real x = point.x * inverse;
  const Real y = point.y * inverse;
  return {{x * on.x, y * on.x, on.y}, {x * on.change_y, y * on.change_y, -on.change_x}};
}

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
  const Real radius = radius_of(point);
  return settled_on(curve.section(section_of(curve, face, radius, point.z)), point, radius);
}

template <class Real>
int hit_limit(const Real* parameters) {
  const int most = to_integer(parameters[0]) * k_section_degree + 2;
  return most < k_primitive_hit_limit ? most : k_primitive_hit_limit;
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const RingExtent<Real> extent = generatrix(parameters).extent(0);
  const Real r = extent.high_r;
  box = {{-r, -r, extent.low_z}, {r, r, extent.high_z}};
  return true;
}

/// By the angle and the parameter of the generatrix, whose sections share it evenly.
template <class Real>
[[gnu::always_inline]] inline SurfacePlace<Real> place_on(const Generatrix<Real>& curve,
                                                          int section, const Vector<Real>& point,
                                                          Real radius) {
  const Real along = nearest_parameter(curve.section(section), radius, point.z);
  return {turn_of(point.x, point.y),
          within_unit((from_integer<Real>(section) + along) / from_integer<Real>(curve.sections))};
}

/// The discs by x and y as far as the solid reaches.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* parameters) {
  const Generatrix<Real> curve = generatrix(parameters);
  if (face >= k_first_disc) {
    const Real inverse = constant<Real>(1) / curve.extent(0).high_r;
    return {from_edges(point.x * inverse), from_edges(point.y * inverse)};
  }
  const Real radius = radius_of(point);
  return place_on(curve, section_of(curve, face, radius, point.z), point, radius);
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr auto k_convert = convert<Real>;
  template <class Real>
  static constexpr SurfaceMap<Real> k_surface_map = surface_place<Real>;
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::revolution
