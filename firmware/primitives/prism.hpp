#pragma once

#include "firmware/primitives/hit_order.hpp"
#include "firmware/primitives/interval.hpp"
#include "firmware/primitives/prism_outline.hpp"

/// An outline swept along z from -1 to 1. Faces: the edges by their numbers, then the upper and the
/// lower end.
///
/// Parameters: those of prism_outline.hpp.
namespace maquette::firmware::prism {

inline constexpr std::uint8_t k_upper_end = k_crossing_limit;
inline constexpr std::uint8_t k_lower_end = k_upper_end + 1;

/// Rays within so many ulps of parallel to z stay at one point of the plane within the rounding
/// of their points.
inline constexpr double k_parallel_tolerance = 4;

/// Whether a point of the plane lies inside: the crossings of a line on one side of it are odd in
/// number. `hits` is working space.
template <class Real>
bool is_inside(const Outline<Real>& curve, Real x, Real y, Hit<Real>* hits) {
  const Real zero = constant<Real>(0);
  const int count = cross_outline(plane_ray(x, y, constant<Real>(1), zero), curve, hits);
  bool inside = false;
  for (int i = 0; i < count; ++i) {
    inside = inside != (hits[i].distance > zero);
  }
  return inside;
}

/// What a slab leaves of the spans between hits in order, in their place; returns the number left.
template <class Real>
int clip_spans(const Interval<Real>& slab, Hit<Real>* hits, int count) {
  int written = 0;
  for (int i = 0; i < count; i += 2) {
    Interval<Real> span{hits[i].distance, hits[i + 1].distance, hits[i].face, hits[i + 1].face};
    enter_at(span, slab.in, slab.in_face);
    leave_at(span, slab.out, slab.out_face);
    written += hits_of(span, hits + written);
  }
  return written;
}

template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const Vector<Real>& o = ray.origin;
  const Vector<Real>& d = ray.direction;
  Interval<Real> slab = whole_ray<Real>();
  if (!clip_slab(slab, o.z, d.z, k_upper_end)) {
    return 0;
  }
  const Outline<Real> curve = outline(parameters);
  const Real across = larger(absolute(d.x), absolute(d.y));
  if (across <= absolute(d.z) * ulps<Real>(k_parallel_tolerance)) {
    const Real middle = -o.z / d.z;
    return is_inside(curve, o.x + d.x * middle, o.y + d.y * middle, hits) ? hits_of(slab, hits) : 0;
  }
  const int count = cross_outline(plane_ray(o.x, o.y, d.x, d.y), curve, hits);
  sort(hits, count);
  return clip_spans(slab, hits, count);
}

template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  if (face >= k_upper_end) {
    const Real end = face == k_upper_end ? one : -one;
    return {{point.x, point.y, end}, {zero, zero, end}};
  }
  const CurvePoint<Real> on = edge_point(outline(parameters), face, point.x, point.y);
  return {{on.x, on.y, larger(-one, smaller(point.z, one))}, {on.change_y, -on.change_x, zero}};
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const Real one = constant<Real>(1);
  const PlaneExtent<Real> extent = outline(parameters).extent(0);
  box = {{extent.low_x, extent.low_y, -one}, {extent.high_x, extent.high_y, one}};
  return true;
}

template <class Real>
int hit_limit(const Real* parameters) {
  const Outline<Real> curve = outline(parameters);
  return crossing_count(curve.lines, curve.cubics) / 2 * 2;
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::prism
