#pragma once

#include "firmware/crossing.hpp"
#include "firmware/prepared.hpp"
#include "firmware/preprocess.hpp"

/// Boolean combination of the crossings of two operands (paper, section II.2; Roth 1982).
namespace maquette::firmware {

/// The medium where two bodies overlap: an opaque one hides a transparent one; of two alike the
/// surface declared first. Commutative and associative, so the order of a union's children is free.
template <class Real>
SurfaceIndex united_medium(const Surface<Real>* surfaces, SurfaceIndex a, SurfaceIndex b) {
  if (a == k_void || a == b) {
    return b;
  }
  if (b == k_void) {
    return a;
  }
  if (surfaces[a].transparent != surfaces[b].transparent) {
    return surfaces[a].transparent ? b : a;
  }
  return a < b ? a : b;
}

/// The medium of a composite where its operands are in the media a and b. What a difference or an
/// intersection leaves is matter of the first operand.
template <class Real>
SurfaceIndex combined_medium(BooleanOperator combination, const Surface<Real>* surfaces,
                             SurfaceIndex a, SurfaceIndex b) {
  switch (combination) {
    case BooleanOperator::union_of:
      return united_medium(surfaces, a, b);
    case BooleanOperator::intersection:
      return b == k_void ? k_void : a;
    case BooleanOperator::difference:
      break;
  }
  return b == k_void ? a : k_void;
}

/// The crossings of an operand that are still to come, and the medium reached.
template <class Real>
struct OperandCursor {
  const Crossing<Real>* next;
  const Crossing<Real>* end;
  SurfaceIndex medium;

  [[nodiscard]] bool is_at_end() const { return next == end; }
  const Crossing<Real>& take() {
    medium = next->medium;
    return *next++;
  }
};

/// Whether two crossings of a ray fall together within the rounding of the numbers they come from:
/// the coordinates of both primitives and the distance along the ray.
template <class Real>
bool coincide(const Prepared<Real>& prepared, const Crossing<Real>& a, const Crossing<Real>& b) {
  const Real apart = absolute(a.distance - b.distance);
  if (apart > prepared.coarse_tolerance) {
    return false;
  }
  charge<Real>(Operation::load, 2);
  const Real coordinates =
      prepared.leaves[a.leaf].scale + prepared.leaves[b.leaf].scale + absolute(a.distance);
  return apart <= coordinates * ulps<Real>(preprocessing::k_crossing_tolerance);
}

/// Takes the nearer of the operands' next crossings, or both when they coincide, so that coincident
/// faces leave neither a skin nor a hole. Returns the crossing whose surface is seen.
template <class Real>
const Crossing<Real>& take_next(const Frame<Real>& frame, BooleanOperator combination,
                                OperandCursor<Real>& a, OperandCursor<Real>& b) {
  if (b.is_at_end()) {
    return a.take();
  }
  if (a.is_at_end()) {
    return b.take();
  }
  if (coincide(frame.prepared, *a.next, *b.next)) {
    const Crossing<Real>& of_a = a.take();
    const Crossing<Real>& of_b = b.take();
    // Of two bodies that begin or end together the one is seen whose medium wins.
    const bool b_is_seen = combination == k_keeps_second &&
                           united_medium(frame.database.surfaces, a.medium, b.medium) == b.medium;
    return b_is_seen ? of_b : of_a;
  }
  return a.next->distance < b.next->distance ? a.take() : b.take();
}

/// Whether a crossing between two media can be seen or bends light; between two opaque bodies there
/// is nothing to see.
template <class Real>
bool is_boundary(const Surface<Real>* surfaces, SurfaceIndex before, SurfaceIndex after) {
  if (before == after) {
    return false;
  }
  return before == k_void || after == k_void || surfaces[before].transparent ||
         surfaces[after].transparent;
}

/// Combines the operands' crossings, `a_count` and then `b_count` of them from `first` on. The
/// result takes their place; its number is returned. Uses as much space again behind the operands.
template <class Real>
[[gnu::noinline]] std::int32_t combine(const Frame<Real>& frame, BooleanOperator combination,
                                       Crossing<Real>* first, std::int32_t a_count,
                                       std::int32_t b_count) {
  charge<Real>(Operation::combination);
  const Surface<Real>* surfaces = frame.database.surfaces;
  OperandCursor<Real> a{first, first + a_count, k_void};
  OperandCursor<Real> b{a.end, a.end + b_count, k_void};
  Crossing<Real>* const result = first + a_count + b_count;
  std::int32_t count = 0;
  SurfaceIndex medium = k_void;
  while (!a.is_at_end() || !b.is_at_end()) {
    charge<Real>(Operation::crossing);
    const Crossing<Real>& seen = take_next(frame, combination, a, b);
    const SurfaceIndex after = combined_medium(combination, surfaces, a.medium, b.medium);
    if (is_boundary(surfaces, medium, after)) {
      result[count++] = {seen.distance, seen.leaf, seen.face, seen.outwards, after};
      medium = after;
    }
  }
  for (std::int32_t i = 0; i < count; ++i) {
    first[i] = result[i];
  }
  return count;
}

}  // namespace maquette::firmware
