#pragma once

#include <cstddef>

#include "firmware/primitives/interval.hpp"

/// A terrain's triangles, made when a ray needs them (Kajiya 1983; subdivision after Fournier,
/// Fussell and Carpenter 1982): each is cut into four at the midpoints of its edges, which are
/// displaced upwards or downwards. Nothing is stored of a triangle.
///
/// Parameters: levels of subdivision; seed; floor and a bound of the greatest height; heights of
/// the square's corners (0, 0), (1, 0), (0, 1), (1, 1); for each level, coarsest first, the
/// greatest displacement of a midpoint and the sum of it and those of the finer levels.
namespace maquette::firmware::terrain {

inline constexpr int k_level_limit = 10;
/// Seeds are below this, so that each is a number of a single's mantissa.
inline constexpr std::int32_t k_seed_end = 1 << 24;
inline constexpr std::ptrdiff_t k_header_reals = 8;
inline constexpr std::ptrdiff_t k_level_reals = 2;

template <class Real>
struct Relief {
  std::int32_t levels;
  std::int32_t seed;
  Real floor;
  Real top;
  const Real* corners;
  const Real* displacements;

  [[nodiscard]] Real displacement(std::int32_t level) const {
    charge<Real>(Operation::load);
    return displacements[level * k_level_reals];
  }
  /// How far the surface may lie above or below the plane of a triangle: midpoints of each level
  /// displace a triangle's points by no more than the greatest displacement of the level.
  [[nodiscard]] Real thickness(std::int32_t level) const {
    charge<Real>(Operation::load);
    return level < levels ? displacements[level * k_level_reals + 1] : constant<Real>(0);
  }
};

template <class Real>
Relief<Real> relief(const Real* parameters) {
  charge<Real>(Operation::load, 4);
  return {to_integer(parameters[0]),
          to_integer(parameters[1]),
          parameters[2],
          parameters[3],
          parameters + 4,
          parameters + k_header_reals};
}

constexpr std::uint32_t rotated(std::uint32_t word, int bits) {
  return word << bits | word >> (32 - bits);
}

/// Three words made one, each bit of which depends on all of theirs: `final` of R. Jenkins,
/// "lookup3.c", 2006. Integers only, so every number type gets the same terrain.
constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  c = (c ^ b) - rotated(b, 14);
  a = (a ^ c) - rotated(c, 11);
  b = (b ^ a) - rotated(a, 25);
  c = (c ^ b) - rotated(b, 16);
  a = (a ^ c) - rotated(c, 4);
  b = (b ^ a) - rotated(a, 14);
  return (c ^ b) - rotated(b, 24);
}

/// A triangle of a level, whose square cells have 2^-level for their edge: the half of a cell below
/// the diagonal through its origin, or that above it. Its own coordinates `along >= across` are x
/// and y below the diagonal, y and x above it.
template <class Real>
struct Triangle {
  std::int32_t level;
  std::int32_t along;  ///< of the cell's origin, in cells
  std::int32_t across;
  bool is_above;
  Real first;   ///< height at the cell's origin
  Real corner;  ///< at the right angle: one cell along
  Real last;    ///< at the far end of the diagonal
};

/// The half of the whole square.
template <class Real>
Triangle<Real> whole(const Relief<Real>& relief, bool is_above) {
  charge<Real>(Operation::load, 3);
  return {
      0, 0, 0, is_above, relief.corners[0], relief.corners[is_above ? 2 : 1], relief.corners[3]};
}

/// A point seen from a triangle, in edges of its cell from the cell's origin.
template <class Real>
struct CellPoint {
  Real along;
  Real across;
};

template <class Real>
CellPoint<Real> cell_point(const Triangle<Real>& triangle, Real x, Real y) {
  const Real cells = from_integer<Real>(1 << triangle.level);
  return {(triangle.is_above ? y : x) * cells - from_integer<Real>(triangle.along),
          (triangle.is_above ? x : y) * cells - from_integer<Real>(triangle.across)};
}

/// Height of the triangle's plane.
template <class Real>
Real height(const Triangle<Real>& triangle, const CellPoint<Real>& point) {
  return triangle.first + (triangle.corner - triangle.first) * point.along +
         (triangle.last - triangle.corner) * point.across;
}

/// Heights of the displaced midpoints of a triangle's edges.
template <class Real>
struct Midpoints {
  Real first;  ///< between the cell's origin and the right angle
  Real last;   ///< between the right angle and the diagonal's far end
  Real diagonal;
};

/// Height in the middle of an edge. The displacement depends on the seed and the place only, so it
/// is the same from both sides and whatever levels follow. The mixing is charged as iterations of a
/// loop that take as long: three for each of its seven lines.
template <class Real>
Real midpoint(const Relief<Real>& relief, const Triangle<Real>& triangle, std::int32_t along,
              std::int32_t across, Real from, Real to) {
  constexpr double k_unit = 1.0 / (1 << 23);
  const std::int32_t shift = k_level_limit - 1 - triangle.level;
  const auto x = static_cast<std::uint32_t>(triangle.is_above ? across : along) << shift;
  const auto y = static_cast<std::uint32_t>(triangle.is_above ? along : across) << shift;
  const std::uint32_t random = mixed(x, y, static_cast<std::uint32_t>(relief.seed));
  const std::int32_t centred = static_cast<std::int32_t>(random >> 8U) - (1 << 23);
  const Real share = from_integer<Real>(centred) * constant<Real>(k_unit);
  return (from + to) * constant<Real>(0.5) + relief.displacement(triangle.level) * share;
}

template <class Real>
Midpoints<Real> midpoints(const Relief<Real>& relief, const Triangle<Real>& triangle) {
  const std::int32_t along = 2 * triangle.along;
  const std::int32_t across = 2 * triangle.across;
  return {midpoint(relief, triangle, along + 1, across, triangle.first, triangle.corner),
          midpoint(relief, triangle, along + 2, across + 1, triangle.corner, triangle.last),
          midpoint(relief, triangle, along + 1, across + 1, triangle.first, triangle.last)};
}

/// The quarter of a triangle that holds a point: at one of its corners, or, turned round, between
/// them.
template <class Real>
Triangle<Real> quarter(const Triangle<Real>& triangle, const Midpoints<Real>& middle,
                       const CellPoint<Real>& point) {
  const Real half = constant<Real>(0.5);
  const std::int32_t level = triangle.level + 1;
  const std::int32_t along = 2 * triangle.along;
  const std::int32_t across = 2 * triangle.across;
  if (point.along < half) {
    return {level, along, across, triangle.is_above, triangle.first, middle.first, middle.diagonal};
  }
  if (point.across > half) {
    return {level,           along + 1,   across + 1,   triangle.is_above,
            middle.diagonal, middle.last, triangle.last};
  }
  if (point.along - point.across > half) {
    return {level,        along + 1,       across,     triangle.is_above,
            middle.first, triangle.corner, middle.last};
  }
  return {level, across, along + 1, !triangle.is_above, middle.first, middle.diagonal, middle.last};
}

/// The finest triangle over a point of the square.
template <class Real>
Triangle<Real> triangle_at(const Relief<Real>& relief, Real x, Real y) {
  Triangle<Real> triangle = whole(relief, x < y);
  while (triangle.level < relief.levels) {
    triangle = quarter(triangle, midpoints(relief, triangle), cell_point(triangle, x, y));
  }
  return triangle;
}

}  // namespace maquette::firmware::terrain
