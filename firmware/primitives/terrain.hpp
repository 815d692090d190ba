#pragma once

#include "firmware/primitives/terrain_parameters.hpp"

/// A terrain over the square from (0, 0) to (1, 1), down to a level floor (paper, section II.1;
/// Kajiya, "New techniques for ray tracing procedurally defined objects", ACM Transactions on
/// Graphics 2, 1983). Faces: 0 the surface, then the walls x = 1, 0, y = 1, 0 and the floor.
///
/// Along a ray the height above the surface is a continuous function of pieces that are straight;
/// hits are where its sign changes. The walk carries the sign from one piece to the next, so in and
/// out alternate whatever rounding does at the edges.
namespace maquette::firmware::terrain {

inline constexpr std::uint8_t k_surface = 0;
inline constexpr std::uint8_t k_first_wall = 1;
inline constexpr std::uint8_t k_floor = 5;
/// A ray that meets more hills than half of this sees no more terrain behind the last of them.
inline constexpr int k_hit_limit = 64;
static_assert(k_hit_limit <= k_primitive_hit_limit);

/// A secondary ray that starts below the surface by no more than this many ulps and rises above
/// it within the first triangle has left it.
inline constexpr double k_departure = 256;

enum class Side : std::uint8_t { unknown, above, below };

/// A ray on its way through the square above the floor. Its parameter s runs from 0 to 1.
template <class Real>
struct Walk {
  Relief<Real> relief;
  Vector<Real> start;
  Vector<Real> change;
  Vector<Real> inverse;  ///< of the change of x, y, x - y; 0 where a ray does not cross such lines
  Interval<Real> interval;
  Real first;  ///< distance where s = 0, and how much of it is passed until s = 1
  Real length;
  Side side;
  int count;
  Hit<Real>* hits;
};

/// 1 / change, or 0 when the change is lost in the rounding of coordinates.
template <class Real>
Real inverse_of(Real change) {
  return absolute(change) > ulps<Real>(1) ? constant<Real>(1) / change : constant<Real>(0);
}

/// Takes note that from s on the ray is on a side of the surface.
template <class Real>
void be(Walk<Real>& walk, Side side, Real s) {
  if (side == walk.side || walk.count == k_hit_limit) {
    return;
  }
  if (walk.side != Side::unknown) {
    const Real distance = smaller(walk.first + walk.length * s, walk.interval.out);
    walk.hits[walk.count++] = {distance, k_surface};
  } else if (side == Side::below) {
    walk.hits[walk.count++] = {walk.interval.in, walk.interval.in_face};
  }
  walk.side = side;
}

/// A point of the way and its height above a triangle's plane.
template <class Real>
struct Sample {
  Real s;
  Real above;
};

template <class Real>
CellPoint<Real> cell_point(const Walk<Real>& walk, const Triangle<Real>& triangle, Real s) {
  return cell_point(triangle, walk.start.x + walk.change.x * s, walk.start.y + walk.change.y * s);
}

template <class Real>
Sample<Real> sample(const Walk<Real>& walk, const Triangle<Real>& triangle, Real s) {
  return {s, walk.start.z + walk.change.z * s - height(triangle, cell_point(walk, triangle, s))};
}

/// Whether the ray begins at a point that rounding has put below the surface it leaves.
template <class Real>
bool departs(const Triangle<Real>& triangle, const Sample<Real>& from, const Sample<Real>& to) {
  const Real zero = constant<Real>(0);
  if (!(from.above < zero) || !(to.above > zero)) {
    return false;
  }
  const Real steep =
      absolute(triangle.corner - triangle.first) + absolute(triangle.last - triangle.corner);
  const Real slope = constant<Real>(1) + steep * from_integer<Real>(1 << triangle.level);
  return from.above > -slope * ulps<Real>(k_departure);
}

/// The part of the way over a finest triangle that it may cross.
template <class Real>
void cross_triangle(Walk<Real>& walk, const Triangle<Real>& triangle, const Sample<Real>& from,
                    const Sample<Real>& to) {
  const Real zero = constant<Real>(0);
  if (walk.side == Side::unknown) {
    be(walk, from.above < zero && !departs(triangle, from, to) ? Side::below : Side::above, from.s);
  }
  const Side side = to.above < zero ? Side::below : Side::above;
  if (side == walk.side) {
    return;
  }
  Real s = from.s;
  if ((from.above < zero) != (to.above < zero)) {
    s += (to.s - from.s) * (from.above / (from.above - to.above));
  }
  be(walk, side, smaller(s, to.s));
}

/// Where the way between two values of s crosses the lines that cut a triangle into four: the ends
/// and up to three values in between, in order.
template <class Real>
struct Cuts {
  Real s[5];
  int count;
};

template <class Real>
void add_cut(Cuts<Real>& cuts, Real s, Real end) {
  if (!(s > cuts.s[0]) || !(s < end)) {
    return;
  }
  int i = cuts.count++;
  for (; s < cuts.s[i - 1]; --i) {
    cuts.s[i] = cuts.s[i - 1];
  }
  cuts.s[i] = s;
}

template <class Real>
Cuts<Real> cuts(const Walk<Real>& walk, const Triangle<Real>& triangle, Real from, Real to) {
  const Real half_cell = constant<Real>(0.5) / from_integer<Real>(1 << triangle.level);
  const std::int32_t column = triangle.is_above ? triangle.across : triangle.along;
  const std::int32_t row = triangle.is_above ? triangle.along : triangle.across;
  const std::int32_t diagonal = 2 * (column - row) + (triangle.is_above ? -1 : 1);
  Cuts<Real> cuts{{from}, 1};
  const Vector<Real>& start = walk.start;
  add_cut(cuts, (from_integer<Real>(2 * column + 1) * half_cell - start.x) * walk.inverse.x, to);
  add_cut(cuts, (from_integer<Real>(2 * row + 1) * half_cell - start.y) * walk.inverse.y, to);
  add_cut(cuts, (from_integer<Real>(diagonal) * half_cell - (start.x - start.y)) * walk.inverse.z,
          to);
  cuts.s[cuts.count] = to;
  return cuts;
}

/// Follows the part of the way over a triangle. Where it is certainly above or below all that the
/// triangle may become, nothing is made of it (the "cheesecake" extents of Kajiya).
template <class Real>
void follow_over(Walk<Real>& walk, const Triangle<Real>& triangle, const Sample<Real>& from,
                 const Sample<Real>& to) {
  charge<Real>(Operation::part);
  const Real half = constant<Real>(0.5);
  const Real thickness = walk.relief.thickness(triangle.level);
  if (smaller(from.above, to.above) > thickness) {
    be(walk, Side::above, from.s);
    return;
  }
  if (larger(from.above, to.above) < -thickness) {
    be(walk, Side::below, from.s);
    return;
  }
  if (triangle.level == walk.relief.levels) {
    cross_triangle(walk, triangle, from, to);
    return;
  }
  const Midpoints<Real> middle = midpoints(walk.relief, triangle);
  const Cuts<Real> way = cuts(walk, triangle, from.s, to.s);
  Sample<Real> begin{};
  for (int i = 0; i < way.count; ++i) {
    const Real inside = (way.s[i] + way.s[i + 1]) * half;
    const Triangle<Real> child = quarter(triangle, middle, cell_point(walk, triangle, inside));
    if (i == 0) {
      begin = sample(walk, child, from.s);
    }
    const Sample<Real> end = sample(walk, child, way.s[i + 1]);
    follow_over(walk, child, begin, end);
    begin = end;
  }
}

/// The half of the square that holds the part of the way between two values of s.
template <class Real>
void follow_half(Walk<Real>& walk, Real from, Real to) {
  const Real inside = (from + to) * constant<Real>(0.5);
  const bool is_above =
      walk.start.x + walk.change.x * inside < walk.start.y + walk.change.y * inside;
  const Triangle<Real> half = whole(walk.relief, is_above);
  follow_over(walk, half, sample(walk, half, from), sample(walk, half, to));
}

/// The part of a ray in the box around the terrain.
template <class Real>
bool clip(const Relief<Real>& relief, const Ray<Real>& ray, Interval<Real>& interval) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Vector<Real>& o = ray.origin;
  const Vector<Real>& d = ray.direction;
  interval = whole_ray<Real>();
  return clip_above(interval, o.x, d.x, one, k_first_wall) &&
         clip_above(interval, -o.x, -d.x, zero, k_first_wall + 1) &&
         clip_above(interval, o.y, d.y, one, k_first_wall + 2) &&
         clip_above(interval, -o.y, -d.y, zero, k_first_wall + 3) &&
         clip_above(interval, o.z, d.z, relief.top, k_surface) &&
         clip_above(interval, -o.z, -d.z, -relief.floor, k_floor) && interval.in < interval.out;
}

/// Only what lies in front of the origin is looked at: spans that end behind it are left out, and
/// one around it begins where the ray enters the box around the terrain.
template <class Real>
int intersect(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits) {
  const Real zero = constant<Real>(0);
  Walk<Real> walk;
  walk.relief = relief(parameters);
  if (!clip(walk.relief, ray, walk.interval) || !(walk.interval.out > zero)) {
    return 0;
  }
  walk.first = larger(walk.interval.in, zero);
  walk.length = walk.interval.out - walk.first;
  walk.start = ray.origin + ray.direction * walk.first;
  walk.change = ray.direction * walk.length;
  walk.inverse = {inverse_of(walk.change.x), inverse_of(walk.change.y),
                  inverse_of(walk.change.x - walk.change.y)};
  walk.side = Side::unknown;
  walk.count = 0;
  walk.hits = hits;
  const Real one = constant<Real>(1);
  const Real diagonal = (walk.start.y - walk.start.x) * walk.inverse.z;
  if (diagonal > zero && diagonal < one) {
    follow_half(walk, zero, diagonal);
    follow_half(walk, diagonal, one);
  } else {
    follow_half(walk, zero, one);
  }
  if (walk.side == Side::below) {
    hits[walk.count++] = {walk.interval.out, walk.interval.out_face};
  }
  return walk.count;
}

template <class Real>
Real inside_unit(Real value) {
  return larger(constant<Real>(0), smaller(value, constant<Real>(1)));
}

/// On the surface the normal is that of the finest triangle over the point, in the triangle's own
/// coordinates (-rise along, -rise across, 1).
template <class Real>
FacePoint<Real> settle(const Vector<Real>& point, std::uint8_t face, const Real* parameters) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Relief<Real> land = relief(parameters);
  FacePoint<Real> settled{{inside_unit(point.x), inside_unit(point.y), point.z}, {zero, zero, one}};
  Vector<Real>& on = settled.position;
  if (face == k_surface) {
    const Triangle<Real> triangle = triangle_at(land, on.x, on.y);
    on.z = height(triangle, cell_point(triangle, on.x, on.y));
    const Real cells = from_integer<Real>(1 << triangle.level);
    settled.normal[triangle.is_above ? 1 : 0] = (triangle.first - triangle.corner) * cells;
    settled.normal[triangle.is_above ? 0 : 1] = (triangle.corner - triangle.last) * cells;
  } else if (face == k_floor) {
    on.z = land.floor;
    settled.normal.z = -one;
  } else {
    const bool is_far = (face - k_first_wall) % 2 == 0;
    on[(face - k_first_wall) / 2] = is_far ? one : zero;
    settled.normal.z = zero;
    settled.normal[(face - k_first_wall) / 2] = is_far ? one : -one;
  }
  return settled;
}

template <class Real>
int hit_limit(const Real* /*parameters*/) {
  return k_hit_limit;
}

template <class Real>
bool bounds(const Real* parameters, Box<Real>& box) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const Relief<Real> land = relief(parameters);
  box = {{zero, zero, land.floor}, {one, one, larger(land.floor, land.top)}};
  return true;
}

/// What the table of primitives lists.
struct Kind {
  template <class Real>
  static constexpr auto k_convert = convert<Real>;
  template <class Real>
  static constexpr Primitive<Real> primitive() {
    return {intersect<Real>, settle<Real>, bounds<Real>, hit_limit<Real>, false};
  }
};

}  // namespace maquette::firmware::terrain
