#pragma once

#include <cstdint>

#include "firmware/primitives/primitive.hpp"

namespace maquette::firmware {

/// The part of a ray inside a convex body, narrowed face by face. Empty when in >= out.
template <class Real>
struct Interval {
  Real in;
  Real out;
  std::uint8_t in_face;
  std::uint8_t out_face;
};

template <class Real>
Interval<Real> whole_ray() {
  return {-far_away<Real>(), far_away<Real>(), 0, 0};
}

template <class Real>
void enter_at(Interval<Real>& interval, Real distance, std::uint8_t face) {
  if (distance > interval.in) {
    interval.in = distance;
    interval.in_face = face;
  }
}

template <class Real>
void leave_at(Interval<Real>& interval, Real distance, std::uint8_t face) {
  if (distance < interval.out) {
    interval.out = distance;
    interval.out_face = face;
  }
}

/// Narrows to the side of a plane on which `direction * t + origin <= limit`. Returns false when
/// the ray runs parallel to the plane outside of it.
template <class Real>
bool clip_above(Interval<Real>& interval, Real origin, Real direction, Real limit,
                std::uint8_t face) {
  const Real zero = constant<Real>(0);
  if (direction > zero) {
    leave_at(interval, (limit - origin) / direction, face);
  } else if (direction < zero) {
    enter_at(interval, (limit - origin) / direction, face);
  } else {
    return origin <= limit;
  }
  return true;
}

/// Narrows to the part where -1 <= direction * t + origin <= 1. `face` is that of the upper plane,
/// the lower one has the next number.
template <class Real>
bool clip_slab(Interval<Real>& interval, Real origin, Real direction, std::uint8_t face) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const auto lower_face = static_cast<std::uint8_t>(face + 1);
  if (direction > zero) {
    const Real inverse = one / direction;
    enter_at(interval, (-one - origin) * inverse, lower_face);
    leave_at(interval, (one - origin) * inverse, face);
  } else if (direction < zero) {
    const Real inverse = one / direction;
    enter_at(interval, (one - origin) * inverse, face);
    leave_at(interval, (-one - origin) * inverse, lower_face);
  } else {
    return absolute(origin) <= one;
  }
  return true;
}

/// The interval as hits; none when it is empty.
template <class Real>
int hits_of(const Interval<Real>& interval, Hit<Real>* hits) {
  if (!(interval.in < interval.out)) {
    return 0;
  }
  hits[0] = {interval.in, interval.in_face};
  hits[1] = {interval.out, interval.out_face};
  return 2;
}

}  // namespace maquette::firmware
