#pragma once

#include <cstring>
#include <limits>

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/real.hpp"
#include "firmware/arithmetic/work.hpp"

namespace maquette::firmware {

/// What this host thread's `Counted` arithmetic has done so far. One meter per thread, because
/// operators have no place for a parameter; read it with `counted_work`.
///
/// `add`, `subtract`, `multiply`, `divide` hold all operations here, those with a zero operand too.
inline thread_local Work counted_meter{};

template <>
struct Meter<struct Counted> {
  static void charge(Operation operation, std::uint32_t count) {
    counted_meter[operation] += count;
  }
};

/// A float that counts what is done with it. Gives the same bits as float.
struct Counted {
  float value;

  Counted() = default;
  constexpr Counted(float initial) : value(initial) {}  // NOLINT(google-explicit-constructor)
};

namespace counting {

/// 1 when the float is plus or minus zero; without a branch.
inline std::uint32_t is_zero(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return static_cast<std::uint32_t>((bits << 1U) == 0);
}

inline void count(Operation operation, std::uint32_t times = 1) {
  counted_meter[operation] += times;
}

}  // namespace counting

/// Sums look for a zero operand by the product. It is also zero when both are tiny; at least one is
/// then below 5.4e-20, which is zero in the package's format.
inline Counted operator+(Counted a, Counted b) {
  counting::count(Operation::add);
  counted_meter[Operation::add_zero] += counting::is_zero(a.value * b.value);
  return {a.value + b.value};
}

inline Counted operator-(Counted a, Counted b) {
  counting::count(Operation::subtract);
  counted_meter[Operation::subtract_zero] += counting::is_zero(a.value * b.value);
  return {a.value - b.value};
}

/// A product is taken as one with a zero operand when it is zero: the package leaves as early on
/// an underflow.
inline Counted operator*(Counted a, Counted b) {
  const float product = a.value * b.value;
  counting::count(Operation::multiply);
  counted_meter[Operation::multiply_zero] += counting::is_zero(product);
  return {product};
}

inline Counted operator/(Counted a, Counted b) {
  counting::count(Operation::divide);
  counted_meter[Operation::divide_zero] += counting::is_zero(a.value);
  return {a.value / b.value};
}

inline Counted operator-(Counted a) {
  counting::count(Operation::negate);
  return {-a.value};
}

inline Counted& operator+=(Counted& a, Counted b) { return a = a + b; }
inline Counted& operator-=(Counted& a, Counted b) { return a = a - b; }
inline Counted& operator*=(Counted& a, Counted b) { return a = a * b; }
inline Counted& operator/=(Counted& a, Counted b) { return a = a / b; }

inline bool operator<(Counted a, Counted b) {
  counting::count(Operation::compare);
  return a.value < b.value;
}
inline bool operator>(Counted a, Counted b) { return b < a; }
inline bool operator<=(Counted a, Counted b) {
  counting::count(Operation::compare);
  return a.value <= b.value;
}
inline bool operator>=(Counted a, Counted b) { return b <= a; }

inline Counted square_root(Counted a) {
  counting::count(Operation::square_root);
  return {square_root(a.value)};
}

inline Counted saturated_inverse(Counted a) {
  counting::count(Operation::divide);
  return {saturated_inverse(a.value)};
}

inline Counted absolute(Counted a) {
  counting::count(Operation::absolute);
  return {absolute(a.value)};
}

inline std::int32_t to_integer(Counted a) {
  counting::count(Operation::float_to_integer);
  return to_integer(a.value);
}

/// The elementary functions are calls of the arithmetic package, counted whole.
inline Counted exponential(Counted a) {
  counting::count(Operation::exponential);
  return {exponential(a.value)};
}

inline Counted power(Counted base, Counted exponent) {
  counting::count(Operation::power);
  return {power(base.value, exponent.value)};
}

inline Counted arc_cosine(Counted a) {
  counting::count(Operation::arc_cosine);
  return {arc_cosine(a.value)};
}

/// This thread's meter with operations on zero operands taken out of their general class.
inline Work counted_work() {
  Work work = counted_meter;
  work[Operation::add] -= work[Operation::add_zero];
  work[Operation::subtract] -= work[Operation::subtract_zero];
  work[Operation::multiply] -= work[Operation::multiply_zero];
  work[Operation::divide] -= work[Operation::divide_zero];
  return work;
}

/// Sets this thread's meter to zero.
inline void reset_counted_work() { counted_meter = Work{}; }

}  // namespace maquette::firmware

/// GLM and the tolerances ask for these; a Counted is a float to them.
template <>
class std::numeric_limits<maquette::firmware::Counted> : public std::numeric_limits<float> {};
