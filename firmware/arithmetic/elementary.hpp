#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/real.hpp"

/// The firmware's own elementary functions, so that no result depends on a C library. Series are
/// summed by Horner's rule; their lengths come from the width of the number type. Plain types only:
/// `Counted` wraps them (firmware/arithmetic/counted.hpp).
namespace maquette::firmware {

namespace elementary {

constexpr double k_ln_2 = 0.693147180559945309417232;
constexpr double k_pi = 3.14159265358979323846264;

template <class Real>
struct Format;
template <>
struct Format<float> {
  using Bits = std::uint32_t;
  static constexpr int mantissa_bits = 23;
  static constexpr int bias = 127;
  static constexpr int exponential_terms = 7;
  static constexpr int logarithm_terms = 5;
  static constexpr int arc_tangent_terms = 10;
  static constexpr int sine_terms = 5;
};
template <>
struct Format<double> {
  using Bits = std::uint64_t;
  static constexpr int mantissa_bits = 52;
  static constexpr int bias = 1023;
  static constexpr int exponential_terms = 14;
  static constexpr int logarithm_terms = 12;
  static constexpr int arc_tangent_terms = 22;
  static constexpr int sine_terms = 9;
};

/// 2 to the power n, for n in the range of normal numbers.
template <class Real>
Real power_of_two(int n) {
  using Bits = typename Format<Real>::Bits;
  const Bits bits = static_cast<Bits>(n + Format<Real>::bias) << Format<Real>::mantissa_bits;
  Real result = 0;
  __builtin_memcpy(&result, &bits, sizeof result);
  return result;
}

/// Writes a positive normal number as mantissa * 2^exponent with the mantissa in [1/sqrt 2, sqrt
/// 2).
template <class Real>
Real split(Real value, int& exponent) {
  using Bits = typename Format<Real>::Bits;
  constexpr int k_shift = Format<Real>::mantissa_bits;
  Bits bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  exponent = static_cast<int>(bits >> k_shift) - Format<Real>::bias;
  bits = (bits & ((Bits{1} << k_shift) - 1)) | (static_cast<Bits>(Format<Real>::bias) << k_shift);
  Real mantissa = 0;
  __builtin_memcpy(&mantissa, &bits, sizeof mantissa);
  if (mantissa > constant<Real>(1.41421356237309504880)) {
    mantissa *= constant<Real>(0.5);
    ++exponent;
  }
  return mantissa;
}

/// Arc tangent of a value in [0, 1].
template <class Real>
Real arc_tangent(Real value) {
  const bool upper = value > constant<Real>(0.41421356237309504880);  // tan(pi/8)
  const Real x = upper ? (value - 1) / (value + 1) : value;
  const Real square = x * x;
  Real sum = 0;
  for (int term = Format<Real>::arc_tangent_terms; term >= 0; --term) {
    const Real coefficient = Real(1) / from_integer<Real>(2 * term + 1);
    sum = coefficient - square * sum;
  }
  return upper ? constant<Real>(k_pi / 4) + x * sum : x * sum;
}

}  // namespace elementary

/// e to the power x; 0 below and the largest number above the range of the type.
template <class Real>
Real exponential(Real x) {
  constexpr int k_limit = elementary::Format<Real>::bias - 1;
  const Real halvings = x * constant<Real>(1 / elementary::k_ln_2);
  if (halvings <= constant<Real>(-k_limit)) {
    return 0;
  }
  if (halvings >= constant<Real>(k_limit)) {
    return std::numeric_limits<Real>::max();
  }
  const int n = to_integer(halvings + (halvings < 0 ? constant<Real>(-0.5) : constant<Real>(0.5)));
  // ln 2 in two parts, so that n * high is exact.
  const Real high = constant<Real>(0.693359375);
  const Real low = constant<Real>(-2.12194440054690582768e-4);
  const Real rest = (x - from_integer<Real>(n) * high) - from_integer<Real>(n) * low;
  Real sum = 1;
  for (int term = elementary::Format<Real>::exponential_terms; term > 0; --term) {
    sum = Real(1) + sum * rest / from_integer<Real>(term);
  }
  return sum * elementary::power_of_two<Real>(n);
}

/// Natural logarithm of a positive normal number.
template <class Real>
Real logarithm(Real x) {
  int exponent = 0;
  const Real fraction = elementary::split(x, exponent) - 1;
  const Real s = fraction / (fraction + 2);
  const Real square = s * s;
  Real sum = 0;
  for (int term = elementary::Format<Real>::logarithm_terms; term >= 0; --term) {
    sum = sum * square + Real(1) / from_integer<Real>(2 * term + 1);
  }
  return from_integer<Real>(exponent) * constant<Real>(elementary::k_ln_2) + 2 * s * sum;
}

/// base to the power exponent, for base >= 0 and exponent > 0; 0 where the base is (sub)zero.
template <class Real>
Real power(Real base, Real exponent) {
  if (base < std::numeric_limits<Real>::min()) {
    return 0;
  }
  return exponential(exponent * logarithm(base));
}

/// Angle in [0, pi/2] radians whose cosine is given, in [0, 1].
template <class Real>
Real arc_cosine(Real cosine) {
  if (cosine >= 1) {
    return 0;
  }
  return 2 * elementary::arc_tangent(square_root((1 - cosine) / (1 + cosine)));
}

/// Sine of an angle in radians, |angle| <= pi/4 at full accuracy.
template <class Real>
Real sine(Real radians) {
  const Real square = radians * radians;
  Real sum = 0;
  for (int term = elementary::Format<Real>::sine_terms; term > 0; --term) {
    sum = (1 - sum) * square / from_integer<Real>((2 * term) * (2 * term + 1));
  }
  return radians * (1 - sum);
}

/// Cosine of an angle in radians, |angle| <= pi/4 at full accuracy.
template <class Real>
Real cosine(Real radians) {
  const Real square = radians * radians;
  Real sum = 0;
  for (int term = elementary::Format<Real>::sine_terms + 1; term > 0; --term) {
    sum = (1 - sum) * square / from_integer<Real>((2 * term - 1) * (2 * term));
  }
  return 1 - sum;
}

}  // namespace maquette::firmware
