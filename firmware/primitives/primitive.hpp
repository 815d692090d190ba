#pragma once

#include <cstdint>

#include "firmware/prepared.hpp"
#include "firmware/vector.hpp"

namespace maquette::firmware {

/// A point where a ray, given in a primitive's local frame, enters or leaves the primitive.
template <class Real>
struct Hit {
  Real distance;
  std::uint8_t face;
};

/// A point of a face, and the outward normal there, not of unit length.
template <class Real>
struct FacePoint {
  Vector<Real> position;
  Vector<Real> normal;
};

/// A primitive in its local frame. Its surface may have several faces, told apart by a number.
template <class Real>
struct Primitive {
  /// Writes the hits of a ray, in and out in turn and in order, also those behind its origin.
  /// Returns their number, which is even and at most what `hit_limit` says.
  int (*intersect)(const Ray<Real>& ray, const Real* parameters, Hit<Real>* hits);
  /// The point of the face nearest to a point that rounding has moved off it, and its normal.
  FacePoint<Real> (*settle)(const Vector<Real>& point, std::uint8_t face, const Real* parameters);
  /// A box around the primitive; returns false when there is none.
  bool (*bounds)(const Real* parameters, Box<Real>& box);
  /// The most hits that a ray has with the primitive of these parameters.
  int (*hit_limit)(const Real* parameters);
  /// A ray has one span in it or none: what it has left it will not meet again.
  bool is_convex;
};

/// Whether every primitive of a kind lies in the unit ball of its local frame, which is smaller
/// than the ball through the corners of its box; a kind of which that is true says so beside
/// itself.
template <class Kind>
inline constexpr bool k_fits_unit_ball = false;

inline constexpr int k_convex_hit_limit = 2;

/// The most hits that any primitive has on a ray.
inline constexpr int k_primitive_hit_limit = 258;

template <class Real>
int convex_hit_limit(const Real* /*parameters*/) {
  return k_convex_hit_limit;
}

}  // namespace maquette::firmware
