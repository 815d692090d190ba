#pragma once

#include "firmware/face_point.hpp"
#include "firmware/messages.hpp"
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
  /// Whether the crossing behind the next one is nearer to another than that.
  [[nodiscard]] bool comes_nearer(const Crossing<Real>& other) const {
    return end - next > 1 &&
           absolute(next[1].distance - other.distance) < absolute(next->distance - other.distance);
  }
  const Crossing<Real>& take() {
    medium = next->medium;
    return *next++;
  }
};

/// Whether the faces that a ray crosses at two places lie in one another rather than form a crease,
/// and are no farther apart than the tolerance, measured across them.
template <class Real>
[[gnu::noinline]] bool faces_coincide(const Frame<Real>& frame, const RayQuery<Real>& query,
                                      const Crossing<Real>& a, const Crossing<Real>& b,
                                      Real tolerance) {
  const Vector<Real> normal = face_point(frame, query, a).normal;
  const Real cosine = glm::dot(normal, face_point(frame, query, b).normal);
  const Real across = (b.distance - a.distance) * glm::dot(normal, query.ray.direction);
  // The cosine of 14 degrees.
  return absolute(cosine) > constant<Real>(0.97) && absolute(across) <= tolerance;
}

/// What the coordinates are known to that two crossings of a ray come from: those of both
/// primitives and the distance along the ray.
template <class Real>
Real crossing_tolerance(const Prepared<Real>& prepared, const Crossing<Real>& a,
                        const Crossing<Real>& b) {
  charge<Real>(Operation::load, 2);
  const Real coordinates =
      prepared.leaves[a.leaf].scale + prepared.leaves[b.leaf].scale + absolute(a.distance);
  return coordinates * ulps<Real>(preprocessing::k_crossing_tolerance);
}

/// Whether two crossings of a ray fall together within the rounding of the numbers they come from,
/// along the ray or, where it grazes the faces, across them.
template <class Real>
bool coincide(const Frame<Real>& frame, const RayQuery<Real>& query, const Crossing<Real>& a,
              const Crossing<Real>& b) {
  const Real apart = absolute(a.distance - b.distance);
  if (apart > frame.prepared.coarse_tolerance) {
    return false;
  }
  const Real tolerance = crossing_tolerance(frame.prepared, a, b);
  if (apart <= tolerance) {
    return true;
  }
  return apart <= tolerance * constant<Real>(preprocessing::k_grazing) &&
         faces_coincide(frame, query, a, b, tolerance);
}

/// Takes both next crossings, which coincide. Returns the one whose surface is seen: of faces that
/// lie in one another, that of the medium that wins; at a crease, the one that makes the passage,
/// since the other face lies in matter or in the void there.
template <class Real>
[[gnu::noinline]] const Crossing<Real>& take_both(const Frame<Real>& frame,
                                                  const RayQuery<Real>& query,
                                                  BooleanOperator combination,
                                                  OperandCursor<Real>& a, OperandCursor<Real>& b) {
  const Surface<Real>* surfaces = frame.database.surfaces;
  const bool b_is_nearer = b.next->distance < a.next->distance;
  const Crossing<Real>& nearer = b_is_nearer ? b.take() : a.take();
  const SurfaceIndex between = combined_medium(combination, surfaces, a.medium, b.medium);
  const Crossing<Real>& farther = b_is_nearer ? a.take() : b.take();
  const SurfaceIndex after = combined_medium(combination, surfaces, a.medium, b.medium);
  const Crossing<Real>& passage = (between == k_void) == (after == k_void) ? nearer : farther;
  const bool b_wins =
      combination == k_keeps_second && united_medium(surfaces, a.medium, b.medium) == b.medium;
  const Crossing<Real>& winner = b_wins == b_is_nearer ? nearer : farther;
  const Leaf<Real>* leaves = frame.database.leaves;
  const bool look_alike = leaves[nearer.leaf].surface == leaves[farther.leaf].surface;
  if (look_alike || !faces_coincide(frame, query, nearer, farther, far_away<Real>())) {
    return passage;
  }
  return winner;
}

/// Takes the nearer of the operands' next crossings, or both when they coincide, so that coincident
/// faces leave neither a skin nor a hole. Returns the crossing whose surface is seen.
template <class Real>
const Crossing<Real>& take_next(const Frame<Real>& frame, const RayQuery<Real>& query,
                                BooleanOperator combination, OperandCursor<Real>& a,
                                OperandCursor<Real>& b) {
  if (b.is_at_end()) {
    return a.take();
  }
  if (a.is_at_end()) {
    return b.take();
  }
  if (coincide(frame, query, *a.next, *b.next) && !a.comes_nearer(*b.next) &&
      !b.comes_nearer(*a.next)) {
    return take_both(frame, query, combination, a, b);
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
[[gnu::noinline]] std::int32_t combine(const Frame<Real>& frame, const RayQuery<Real>& query,
                                       BooleanOperator combination, Crossing<Real>* first,
                                       std::int32_t a_count, std::int32_t b_count) {
  const InLeg<Real> leg(Stage::combination, [&frame, &query, a_count, b_count] {
    return messages::of_combination(frame, query, a_count + b_count);
  });
  const InFunction<Real> here(Function::combination);
  charge<Real>(Operation::combination);
  const Surface<Real>* surfaces = frame.database.surfaces;
  OperandCursor<Real> a{first, first + a_count, k_void};
  OperandCursor<Real> b{a.end, a.end + b_count, k_void};
  Crossing<Real>* const result = first + a_count + b_count;
  std::int32_t count = 0;
  SurfaceIndex medium = k_void;
  while (!a.is_at_end() || !b.is_at_end()) {
    charge<Real>(Operation::crossing);
    const Crossing<Real>& seen = take_next(frame, query, combination, a, b);
    const SurfaceIndex after = combined_medium(combination, surfaces, a.medium, b.medium);
    if (is_boundary(surfaces, medium, after)) {
      result[count++] = {seen.distance, seen.leaf, seen.face, seen.outwards, after};
      medium = after;
    }
  }
  for (std::int32_t i = 0; i < count; ++i) {
    first[i] = result[i];
  }
  returns_also<Real>(messages::k_crossing * count);
  return count;
}

}  // namespace maquette::firmware
