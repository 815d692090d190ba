#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/number_format.hpp"
#include "firmware/arithmetic/real.hpp"
#include "firmware/arithmetic/work.hpp"
#include "firmware/projection.hpp"

/// The number type of a board's program: numbers of a format, computed by an arithmetic package.
/// Its routines take their operands in D7 and D6, leave the result in D7 and use up D3 to D5; after
/// a comparison the conditions of the processor hold for D7 against D6, where both are numbers:
/// what is not a number is neither less nor equal. For the 68000 alone.
namespace maquette::firmware {

template <class Format>
struct Number {
  std::uint32_t bits;

  Number() = default;
  /// Of constants only: they are converted while compiling, so that no conversion is left.
  [[gnu::always_inline]] constexpr Number(float value)  // NOLINT(google-explicit-constructor)
      : bits(Format::bits_of(value)) {}

  [[gnu::always_inline]] static Number of_bits(std::uint32_t bits) {
    Number number;
    number.bits = bits;
    return number;
  }

  [[gnu::always_inline]] friend Number operator+(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__("jsr arithmetic_add" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
    return of_bits(left);
  }

  [[gnu::always_inline]] friend Number operator-(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__("jsr arithmetic_subtract" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
    return of_bits(left);
  }

  [[gnu::always_inline]] friend Number operator*(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__("jsr arithmetic_multiply" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
    return of_bits(left);
  }

  [[gnu::always_inline]] friend Number operator/(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__("jsr arithmetic_divide" : "+d"(left) : "d"(right) : "d3", "d4", "d5", "cc");
    return of_bits(left);
  }

  /// In line.
  [[gnu::always_inline]] friend Number operator-(Number a) {
    return of_bits(Format::negative(a.bits));
  }

  friend Number& operator+=(Number& a, Number b) { return a = a + b; }
  friend Number& operator-=(Number& a, Number b) { return a = a - b; }
  friend Number& operator*=(Number& a, Number b) { return a = a * b; }
  friend Number& operator/=(Number& a, Number b) { return a = a / b; }

  /// Comparisons branch on the conditions that the package leaves.
  [[gnu::always_inline]] friend bool operator<(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__ goto("jsr arithmetic_compare\n\tjlt %l[holds]"
                 :
                 : "d"(left), "d"(right)
                 : "d3", "d4", "d5", "cc"
                 : holds);
    return false;
  holds:
    return true;
  }

  [[gnu::always_inline]] friend bool operator<=(Number a, Number b) {
    register std::uint32_t left __asm__("d7") = a.bits;
    register std::uint32_t right __asm__("d6") = b.bits;
    __asm__ goto("jsr arithmetic_compare\n\tjle %l[holds]"
                 :
                 : "d"(left), "d"(right)
                 : "d3", "d4", "d5", "cc"
                 : holds);
    return false;
  holds:
    return true;
  }

  [[gnu::always_inline]] friend bool operator>(Number a, Number b) { return b < a; }
  [[gnu::always_inline]] friend bool operator>=(Number a, Number b) { return b <= a; }
};

template <class Format>
[[gnu::always_inline]] inline Number<Format> square_root(Number<Format> a) {
  register std::uint32_t value __asm__("d7") = a.bits;
  __asm__("jsr arithmetic_square_root" : "+d"(value) : : "d3", "d4", "d5", "d6", "cc");
  return Number<Format>::of_bits(value);
}

template <class Format>
[[gnu::always_inline]] constexpr Number<Format> absolute(Number<Format> a) {
  a.bits = Format::magnitude(a.bits);
  return a;
}

template <class Format>
[[gnu::always_inline]] inline std::int32_t to_integer(Number<Format> a) {
  register std::uint32_t value __asm__("d7") = a.bits;
  __asm__("jsr arithmetic_to_integer" : "+d"(value) : : "d3", "d4", "d5", "cc");
  return static_cast<std::int32_t>(value);
}

template <class Format>
inline Number<Format> saturated_inverse(Number<Format> length) {
  return length > 0 ? 1 / length : far_away<Number<Format>>();
}

template <class Format>
struct RayCounting<Number<Format>> {
  using Counts = RayNumbers<std::uint16_t>;
};

/// Which program a board holds the host says (synthesis_parallel.cpp).
template <class Format>
inline constexpr bool k_is_linked_for_projection<Number<Format>> = true;

}  // namespace maquette::firmware

/// GLM and the tolerances ask for these: every format has the mantissa of a float.
template <class Format>
class std::numeric_limits<maquette::firmware::Number<Format>> : public std::numeric_limits<float> {
};
