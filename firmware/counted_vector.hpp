#pragma once

#include "firmware/counted.hpp"
#include "firmware/vector.hpp"

/// Vector operators of `Counted` that look for zero operands in all components at once. They give
/// the bits and the counts of the component-wise operators; GLM's templates give way to them.
namespace maquette::firmware {

namespace counting {

using Lanes = float __attribute__((vector_size(16)));
using LaneFlags = std::int32_t __attribute__((vector_size(16)));

/// Three components and a one, so that the fourth lane never counts as zero.
inline Lanes lanes_of(const Vector<Counted>& v) {
  return Lanes{v.x.value, v.y.value, v.z.value, 1.0F};
}

inline Vector<Counted> vector_of(Lanes lanes) { return {lanes[0], lanes[1], lanes[2]}; }

/// Found zeros per lane; a flag is -1.
struct ZeroFlags {
  LaneFlags add;
  LaneFlags subtract;
  LaneFlags multiply;
};
inline thread_local ZeroFlags zero_flags{};

}  // namespace counting

inline Vector<Counted> operator+(const Vector<Counted>& a, const Vector<Counted>& b) {
  const counting::Lanes x = counting::lanes_of(a);
  const counting::Lanes y = counting::lanes_of(b);
  counting::count(Operation::add, 3);
  counting::zero_flags.add += (x == 0) | (y == 0);
  return counting::vector_of(x + y);
}

inline Vector<Counted> operator-(const Vector<Counted>& a, const Vector<Counted>& b) {
  const counting::Lanes x = counting::lanes_of(a);
  const counting::Lanes y = counting::lanes_of(b);
  counting::count(Operation::subtract, 3);
  counting::zero_flags.subtract += (x == 0) | (y == 0);
  return counting::vector_of(x - y);
}

inline Vector<Counted> operator*(const Vector<Counted>& a, const Vector<Counted>& b) {
  const counting::Lanes product = counting::lanes_of(a) * counting::lanes_of(b);
  counting::count(Operation::multiply, 3);
  counting::zero_flags.multiply += product == 0;
  return counting::vector_of(product);
}

inline Vector<Counted> operator*(const Vector<Counted>& a, Counted b) {
  const float v = b.value;
  const counting::Lanes product = counting::lanes_of(a) * counting::Lanes{v, v, v, 1.0F};
  counting::count(Operation::multiply, 3);
  counting::zero_flags.multiply += product == 0;
  return counting::vector_of(product);
}

}  // namespace maquette::firmware
