#pragma once

#include "firmware/primitives/hit_order.hpp"
#include "firmware/primitives/patch_conversion.hpp"
#include "firmware/primitives/patch_point.hpp"
#include "firmware/primitives/primitive.hpp"
#include "firmware/primitives/surface_map.hpp"

/// A set of bicubic Bezier patches. A closed one bounds a solid; any other is a sheet without
/// thickness, which a ray enters and leaves at once. Faces: the patches by their numbers, and
/// whether the ray came from behind.
///
/// The parameters are those of a set (patch_set.hpp), which boards make of a net of control points
/// (patch_conversion.hpp). The local frame holds the control points in [-1, 1].
namespace maquette::firmware::patches {

inline constexpr int k_hit_limit = 128;
static_assert(k_hit_limit <= k_primitive_hit_limit);
inline constexpr std::uint8_t k_from_behind = 0x80;

/// Spacings, per unit of the local frame, by which boxes are too small for rounded rays.
inline constexpr double k_box_margin = 16;

/// A ray as the intersection of two planes, parallel to the two axes along which it goes least, and
/// its point nearest to the origin, where no large numbers cancel.
template <class Real>
struct PlanePair {
  int x;  ///< the axes, in cyclic order
  int y;
  int depth;  ///< along which the ray goes most
  Real slope_x;
  Real slope_y;
  Real offset_x;
  Real offset_y;
  Vector<Real> nearest;
  Vector<Real> direction;
  Real base;     ///< distance of that point
  Real inverse;  ///< distance per unit of depth
};

template <class Real>
PlanePair<Real> planes_of(const Ray<Real>& ray) {
  const Vector<Real>& d = ray.direction;
  const Real x = absolute(d.x);
  const Real y = absolute(d.y);
  const Real z = absolute(d.z);
  PlanePair<Real> planes;
  planes.depth = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
  planes.x = (planes.depth + 1) % 3;
  planes.y = (planes.depth + 2) % 3;
  planes.direction = d;
  planes.base = -glm::dot(ray.origin, d) / glm::dot(d, d);
  planes.nearest = ray.origin + d * planes.base;
  planes.inverse = constant<Real>(1) / d[planes.depth];
  planes.slope_x = d[planes.x] * planes.inverse;
  planes.slope_y = d[planes.y] * planes.inverse;
  const Real depth = planes.nearest[planes.depth];
  planes.offset_x = planes.nearest[planes.x] - planes.slope_x * depth;
  planes.offset_y = planes.nearest[planes.y] - planes.slope_y * depth;
  return planes;
}

template <class Real>
Image<Real> image_of(const PlanePair<Real>& planes, const Real* points) {
  Image<Real> image;
  for (int i = 0; i < k_net_points; ++i) {
    charge<Real>(Operation::load, 3);
    const Real* point = points + i * k_point_reals;
    const Real depth = point[planes.depth];
    image.x.at[i] = point[planes.x] - planes.slope_x * depth - planes.offset_x;
    image.y.at[i] = point[planes.y] - planes.slope_y * depth - planes.offset_y;
  }
  return image;
}

/// Whether the line of a ray certainly passes a box, given by its centre and half its edges: as
/// seen along one of the axes.
template <class Real>
bool misses(const PlanePair<Real>& planes, const Real* box) {
  const Real margin = ulps<Real>(k_box_margin);
  charge<Real>(Operation::load, 6);
  const Vector<Real>& d = planes.direction;
  const Vector<Real> way(absolute(d.x), absolute(d.y), absolute(d.z));
  const Vector<Real> apart(box[0] - planes.nearest.x, box[1] - planes.nearest.y,
                           box[2] - planes.nearest.z);
  const Vector<Real> half(box[3] + margin, box[4] + margin, box[5] + margin);
  return absolute(d.y * apart.z - d.z * apart.y) > half.y * way.z + half.z * way.y ||
         absolute(d.z * apart.x - d.x * apart.z) > half.z * way.x + half.x * way.z ||
         absolute(d.x * apart.y - d.y * apart.x) > half.x * way.y + half.y * way.x;
}

/// The hits of a ray, as many as there is room for.
template <class Real>
struct HitList {
  Hit<Real>* hits;
  int count;
};

/// Adds the hits on a patch: one for each root, two on a sheet.
template <class Real>
void intersect_patch(const PlanePair<Real>& planes, const PatchSet<Real>& set, int number,
                     HitList<Real>& list) {
  const Real* points = set.patch(number);
  RootList<Real> roots;
  find_roots(image_of(planes, points), set.method, roots);
  for (int i = 0; i < roots.count; ++i) {
    const Root<Real>& root = roots.at[i];
    const Real depth =
        value_at(points + planes.depth, k_point_reals, basis_at(root.u), basis_at(root.v));
    const Real distance = planes.base + (depth - planes.nearest[planes.depth]) * planes.inverse;
    const bool from_behind = (root.winding < 0) == (planes.inverse < constant<Real>(0));
    const Hit<Real> hit{distance,
                        static_cast<std::uint8_t>(from_behind ? number | k_from_behind : number)};
    for (int k = set.is_solid ? 1 : 0; k < 2 && list.count < k_hit_limit; ++k) {
      list.hits[list.count++] = hit;
    }
  }
}

/// Adds the hits on the patches below a node of the tree, in no order.
template <class Real>
void intersect_node(const PlanePair<Real>& planes, const PatchSet<Real>& set, int node, int first,
                    int patches, HitList<Real>& list) {
  charge<Real>(Operation::part);
  if (misses(planes, set.boxes + node * k_box_reals)) {
    return;
  }
  if (patches == 1) {
    intersect_patch(planes, set, first, list);
    return;
  }
  const int half = patches / 2;
  intersect_node(planes, set, node + 1, first, half, list);
  intersect_node(planes, set, node + 2 * half, first + half, patches - half, list);
}

/// Takes one of an odd number of hits out: the first that is not in turn from the front and from
/// behind. A closed set whose patches meet in the same control points never has such a number.
template <class Real>
int without_odd(Hit<Real>* hits, int count) {
  int odd = 0;
  while (odd < count - 1 && (hits[odd].face >= k_from_behind) == (odd % 2 == 1)) {
    ++odd;
  }
  for (int i = odd; i + 1 < count; ++i) {
    hits[i] = hits[i + 1];
  }
  return count - 1;
}

template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const PatchSet<Real> set = patch_set(parameters);
  const PlanePair<Real> planes = planes_of(ray);
  HitList<Real> list{hits, 0};
  intersect_node(planes, set, 0, 0, set.patches, list);
  sort(hits, list.count);
  return list.count % 2 == 0 ? list.count : without_odd(hits, list.count);
}

/// The normal is that of a solid outwards, of a sheet to the side from which the ray came.
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const PatchSet<Real> set = patch_set(parameters);
  const Real* points = set.patch(face % k_from_behind);
  const Place<Real> place = nearest_place(points, point);
  const Basis<Real> of_u = basis_at(place.u);
  const Basis<Real> of_v = basis_at(place.v);
  const Vector<Real> front = normal_at(points, place.u, place.v);
  return {
      {value_at(points, k_point_reals, of_u, of_v), value_at(points + 1, k_point_reals, of_u, of_v),
       value_at(points + 2, k_point_reals, of_u, of_v)},
      !set.is_solid && face >= k_from_behind ? -front : front};
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const Real* at = patch_set(parameters).boxes;
  charge<Real>(Operation::load, 6);
  const Vector<Real> center(at[0], at[1], at[2]);
  const Vector<Real> half(at[3], at[4], at[5]);
  box = {center - half, center + half};
  return true;
}

template <class Real>
int hit_limit(const Real* parameters) {
  const PatchSet<Real> set = patch_set(parameters);
  const int hits = set.patches * RootList<Real>::k_limit * (set.is_solid ? 1 : 2);
  return hits < k_hit_limit ? hits : k_hit_limit;
}

/// Each patch by its own parameters.
template <class Real>
SurfacePlace<Real> surface_place(const Vector<Real>& point, std::uint8_t face,
                                 const Real* parameters) {
  const PatchSet<Real> set = patch_set(parameters);
  const Place<Real> place = nearest_place(set.patch(face % k_from_behind), point);
  return {within_unit(place.u), within_unit(place.v)};
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

}  // namespace maquette::firmware::patches
