#pragma once

#include <cstdint>
#include <limits>

#include "firmware/arithmetic/elementary.hpp"

/// What the elementary functions ask of a number type in the FFP format: one that is made of bits
/// by `of_bits` and has them in `bits`. What differs from a float is the range, and how a number is
/// made of its parts.
namespace maquette::firmware::maquette_ffp {

/// One is 0.1 (binary) times two.
inline constexpr std::uint32_t k_exponent_of_one = 65;

/// As many terms as a float needs, whose mantissa this is.
struct ElementaryFormat : elementary::Format<float> {
  static constexpr int bias = 63;  ///< numbers of 2^63 and more are beyond the range
};

template <class Number>
[[gnu::always_inline]] inline Number power_of_two(int n) {
  return Number::of_bits(0x80000000U | (static_cast<std::uint32_t>(n) + k_exponent_of_one));
}

/// Writes a positive number as mantissa * 2^exponent, as elementary::split does.
template <class Number>
[[gnu::always_inline]] inline Number split(Number value, int& exponent) {
  constexpr std::uint32_t k_mask = 0x7F;
  exponent = static_cast<int>(value.bits & k_mask) - static_cast<int>(k_exponent_of_one);
  Number mantissa = Number::of_bits((value.bits & ~k_mask) | k_exponent_of_one);
  if (mantissa > constant<Number>(1.41421356237309504880)) {
    mantissa *= constant<Number>(0.5);
    ++exponent;
  }
  return mantissa;
}

struct Limits : std::numeric_limits<float> {
  static constexpr float min() { return 0x1p-65F; }
  static constexpr float max() { return 0x1.fffffep62F; }
};

}  // namespace maquette::firmware::maquette_ffp
