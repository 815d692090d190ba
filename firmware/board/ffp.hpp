#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/maquette_ffp/format.hpp"
#include "firmware/arithmetic/real.hpp"

/// The number type of a board's program: FFP numbers, computed by the arithmetic package
/// (maquette_ffp/). Its routines take their operands in D7 and D6, leave the result in D7 and use
/// up D3 to D5; after a comparison the conditions of the processor hold for D7 against D6. For the
/// 68000 alone.
namespace maquette::firmware {

/// A number in the FFP format.
struct Ffp {
  std::uint32_t bits;

  Ffp() = default;
  /// Of constants only: they are converted while compiling, so that no conversion is left.
  [[gnu::always_inline]] constexpr Ffp(float value)  // NOLINT(google-explicit-constructor)
      : bits(maquette_ffp::to_ffp(value)) {}
};

namespace ffp {

[[gnu::always_inline]] inline Ffp of_bits(std::uint32_t bits) {
  Ffp number;
  number.bits = bits;
  return number;
}

}  // namespace ffp

[[gnu::always_inline]] inline Ffp operator+(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__("jsr ffp_add" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
  return ffp::of_bits(left);
}

[[gnu::always_inline]] inline Ffp operator-(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__("jsr ffp_subtract" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
  return ffp::of_bits(left);
}

[[gnu::always_inline]] inline Ffp operator*(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__("jsr ffp_multiply" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
  return ffp::of_bits(left);
}

[[gnu::always_inline]] inline Ffp operator/(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__("jsr ffp_divide" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
  return ffp::of_bits(left);
}

/// Two instructions in line: zero has no sign.
[[gnu::always_inline]] inline Ffp operator-(Ffp a) {
  return ffp::of_bits(a.bits == 0 ? 0 : a.bits ^ maquette_ffp::k_sign);
}

inline Ffp& operator+=(Ffp& a, Ffp b) { return a = a + b; }
inline Ffp& operator-=(Ffp& a, Ffp b) { return a = a - b; }
inline Ffp& operator*=(Ffp& a, Ffp b) { return a = a * b; }
inline Ffp& operator/=(Ffp& a, Ffp b) { return a = a / b; }

/// Comparisons branch on the conditions that the package leaves.
[[gnu::always_inline]] inline bool operator<(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__ goto("jsr ffp_compare\n\tjlt %l[holds]"
               :
               : "d"(left), "d"(right)
               : "d3", "d4", "d5", "cc"
               : holds);
  return false;
holds:
  return true;
}

[[gnu::always_inline]] inline bool operator<=(Ffp a, Ffp b) {
  register std::uint32_t left __asm__("d7") = a.bits;
  register std::uint32_t right __asm__("d6") = b.bits;
  __asm__ goto("jsr ffp_compare\n\tjle %l[holds]"
               :
               : "d"(left), "d"(right)
               : "d3", "d4", "d5", "cc"
               : holds);
  return false;
holds:
  return true;
}

[[gnu::always_inline]] inline bool operator>(Ffp a, Ffp b) { return b < a; }
[[gnu::always_inline]] inline bool operator>=(Ffp a, Ffp b) { return b <= a; }

[[gnu::always_inline]] inline Ffp square_root(Ffp a) {
  register std::uint32_t value __asm__("d7") = a.bits;
  __asm__("jsr ffp_square_root" : "+d"(value) : : "d3", "d4", "d5", "d6", "cc");
  return ffp::of_bits(value);
}

[[gnu::always_inline]] constexpr Ffp absolute(Ffp a) {
  a.bits &= ~maquette_ffp::k_sign;
  return a;
}

[[gnu::always_inline]] inline std::int32_t to_integer(Ffp a) {
  register std::uint32_t value __asm__("d7") = a.bits;
  __asm__("jsr ffp_to_integer" : "+d"(value) : : "d3", "d4", "d5", "cc");
  return static_cast<std::int32_t>(value);
}

template <>
inline Ffp from_integer<Ffp>(std::int32_t integer) {
  register std::int32_t value __asm__("d7") = integer;
  __asm__("jsr ffp_from_integer" : "+d"(value) : : "d3", "d4", "d5", "cc");
  return ffp::of_bits(static_cast<std::uint32_t>(value));
}

namespace elementary {

/// One is 0.1 (binary) times two.
inline constexpr std::uint32_t k_exponent_of_one = 65;

template <>
struct Format<Ffp> : Format<float> {
  static constexpr int bias = 63;  ///< numbers of 2^63 and more are beyond the range
};

template <>
inline Ffp power_of_two<Ffp>(int n) {
  return ffp::of_bits(0x80000000U | (static_cast<std::uint32_t>(n) + k_exponent_of_one));
}

template <>
inline Ffp split<Ffp>(Ffp value, int& exponent) {
  constexpr std::uint32_t k_mask = 0x7F;
  exponent = static_cast<int>(value.bits & k_mask) - static_cast<int>(k_exponent_of_one);
  Ffp mantissa = ffp::of_bits((value.bits & ~k_mask) | k_exponent_of_one);
  if (mantissa > constant<Ffp>(1.41421356237309504880)) {
    mantissa *= constant<Ffp>(0.5);
    ++exponent;
  }
  return mantissa;
}

}  // namespace elementary

/// The elementary functions are the firmware's own (board/elementary.cpp). They have names by which
/// a simulator finds them, since another arithmetic package has its own, at another cost.
Ffp exponential(Ffp x) __asm__("ffp_exponential");
Ffp power(Ffp base, Ffp exponent) __asm__("ffp_power");
Ffp arc_cosine(Ffp cosine) __asm__("ffp_arc_cosine");

inline Ffp saturated_inverse(Ffp length) {
  return length > constant<Ffp>(0) ? constant<Ffp>(1) / length : far_away<Ffp>();
}

}  // namespace maquette::firmware

/// GLM and the tolerances ask for these: the mantissa is as wide as that of a float, the range
/// smaller.
template <>
class std::numeric_limits<maquette::firmware::Ffp> : public std::numeric_limits<float> {
 public:
  static constexpr float min() { return 0x1p-65F; }
  static constexpr float max() { return 0x1.fffffep62F; }
};
