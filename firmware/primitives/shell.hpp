#pragma once

#include "firmware/primitives/revolution.hpp"

/// What a generatrix sweeps about the z axis and nothing else: a sheet without thickness, which a
/// ray enters and leaves at once. No discs stand at open ends. The parameters are those of a
/// generatrix (generatrix.hpp). Faces: its sections by their numbers, shared as those of a solid,
/// and whether the ray came from behind, that is from the left of the chain.
namespace maquette::firmware::shell {

inline constexpr std::uint8_t k_from_behind = 0x80;
inline constexpr int k_section_faces = k_from_behind;

/// Adds both hits of a sheet.
template <class Real>
void add_hit(HitList<Real>& list, Real distance, std::uint8_t face, bool from_behind) {
  const Hit<Real> hit{distance,
                      static_cast<std::uint8_t>(from_behind ? face | k_from_behind : face)};
  list.hits[list.count++] = hit;
  list.hits[list.count++] = hit;
}

/// Adds the hits of a section, in no order. Along the section its equation changes sign at each in
/// turn, from where the line passes the section's height outside of it to where it passes inside
/// and back, and each change is from one side; so rounding leaves no two neighbours on the same
/// side.
template <class Real>
void intersect_section(const revolution::AxialRay<Real>& ray, const Real* points, std::uint8_t face,
                       HitList<Real>& list) {
  const Real zero = constant<Real>(0);
  if (ray.is_level()) {
    revolution::visit_level(ray, points, [&](Real distance, bool is_far, Real change) {
      add_hit(list, distance, face, (change > zero) == is_far);
    });
    return;
  }
  Hit<Real> hits[revolution::k_section_degree];
  const int count = revolution::intersect_section(ray, points, face, hits);
  const bool begins_outside = !(ray.outside_by(points[0], points[1]) < zero);
  bool from_behind = begins_outside == (ray.slope < zero);
  for (int i = 0; i < count; ++i) {
    add_hit(list, hits[i].distance, face, from_behind);
    from_behind = !from_behind;
  }
}

/// How hits of a shell's section are added.
struct SheetSection {
  template <class Real>
  [[gnu::always_inline]] static void add_hits(revolution::TreeWalk<Real>& walk, int section) {
    make_room(walk.list, 2 * revolution::k_section_degree);
    intersect_section(walk.ray, walk.curve.section(section),
                      revolution::face_of<k_section_faces>(section), walk.list);
  }
};

template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  revolution::TreeWalk<Real> walk{revolution::axial_ray(ray), revolution::generatrix(parameters),
                                  hit_list(hits)};
  charge<Real>(Operation::load);
  walk.ray.root_tolerance *= parameters[revolution::k_root_tolerance];
  revolution::intersect_node<SheetSection>(walk, 0, 0, walk.curve.sections);
  return in_order(walk.list);
}

/// The section of a face at a point.
template <class Real>
int section_at(const revolution::Generatrix<Real>& curve, std::uint8_t face, Real radius, Real z) {
  return revolution::section_of<k_section_faces>(curve, face % k_from_behind, radius, z);
}

/// The normal is to the side from which the ray came.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const revolution::Generatrix<Real> curve = revolution::generatrix(parameters);
  const Real radius = revolution::radius_of(point);
  const FacePoint<Real> front = revolution::settled_on(
      curve.section(section_at(curve, face, radius, point.z)), point, radius);
  return {front.position, face >= k_from_behind ? -front.normal : front.normal};
}

template <class Real>
int hit_limit(const Real* parameters) {
  const int most = to_integer(parameters[0]) * (2 * revolution::k_section_degree);
  return most < k_primitive_hit_limit ? most : k_primitive_hit_limit;
}

template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* parameters) {
  const revolution::Generatrix<Real> curve = revolution::generatrix(parameters);
  const Real radius = revolution::radius_of(point);
  return revolution::place_on(curve, section_at(curve, face, radius, point.z), point, radius);
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr auto k_convert = revolution::convert<Real>;
  template <class Real>
  static constexpr SurfaceMap<Real> k_surface_map = surface_place<Real>;
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, revolution::bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::shell
