#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/function.hpp"
#include "firmware/arithmetic/work.hpp"

namespace maquette::firmware {

/// Where the work of a number type goes. Plain types have no meter; `Counted` brings its own.
template <class Real>
struct Meter {
  static constexpr void charge(Operation /*operation*/, std::uint32_t /*count*/) {}
};

/// Declares an event of the process, which the number type cannot count itself.
template <class Real>
constexpr void charge(Operation operation, std::uint32_t count = 1) {
  Meter<Real>::charge(operation, count);
}

/// A constant of the program text; costs nothing but its load, which the call overhead holds.
/// Always inline, so that no double survives in the board's code.
template <class Real>
[[gnu::always_inline]] constexpr Real constant(double value) {
  return static_cast<Real>(static_cast<float>(value));
}
template <>
[[gnu::always_inline]] constexpr double constant<double>(double value) {
  return value;
}

inline float square_root(float value) { return __builtin_sqrtf(value); }
inline double square_root(double value) { return __builtin_sqrt(value); }

constexpr float absolute(float value) { return __builtin_fabsf(value); }
constexpr double absolute(double value) { return __builtin_fabs(value); }

/// Truncates towards zero; the value must fit.
constexpr std::int32_t to_integer(float value) { return static_cast<std::int32_t>(value); }
constexpr std::int32_t to_integer(double value) { return static_cast<std::int32_t>(value); }

template <class Real>
constexpr Real from_integer(std::int32_t value) {
  charge<Real>(Operation::integer_to_float);
  return static_cast<Real>(static_cast<float>(value));
}
template <>
constexpr double from_integer<double>(std::int32_t value) {
  return value;
}

template <class Real>
constexpr Real smaller(Real a, Real b) {
  return b < a ? b : a;
}

template <class Real>
constexpr Real larger(Real a, Real b) {
  return a < b ? b : a;
}

/// The unit of every tolerance: so many times the relative ulp of the number type.
template <class Real>
[[gnu::always_inline]] constexpr Real ulps(double count) {
  return constant<Real>(count * static_cast<double>(std::numeric_limits<Real>::epsilon()));
}

/// 1 / value of a length; of zero the largest number that is used, as the board's arithmetic
/// package saturates: its format has no infinities (MC68343 FFP sources).
constexpr float saturated_inverse(float length) { return length > 0 ? 1 / length : 1e18F; }
constexpr double saturated_inverse(double length) { return length > 0 ? 1 / length : 1e18; }

/// Stands for a distance that is never reached; inside the range of the FFP format (9.22e18).
template <class Real>
constexpr Real far_away() {
  return constant<Real>(1e18);
}

}  // namespace maquette::firmware
