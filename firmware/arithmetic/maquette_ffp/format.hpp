#pragma once

#include <cstdint>

/// Motorola's Fast Floating Point format, as the package's routines take and give it in registers:
/// 24 bits of mantissa, no bit hidden, above a sign bit and 7 bits of exponent in excess of 64. A
/// number is 0.mantissa * 2^(exponent - 64), with the mantissa's highest bit set; zero has all bits
/// zero. There is nothing else. A float of 2^-65 to 2^63 has the same mantissa here.
///
/// Results are rounded to nearest even as if the exponent had no limits. Then one that is 2^63 or
/// more is the largest number with its sign, one below 2^-65 zero.
namespace maquette::firmware::maquette_ffp {

/// The largest number is 2^63 - 2^39.
inline constexpr std::uint32_t k_largest = 0xffffff7f;
inline constexpr std::uint32_t k_sign = 0x80;

/// A float in the format: zero below its range, the largest number of the same sign above it.
constexpr std::uint32_t to_ffp(float value) {
  constexpr std::uint32_t k_bias_difference = 62;
  const auto bits = __builtin_bit_cast(std::uint32_t, value);
  const std::uint32_t sign = bits >> 24U & k_sign;
  const std::uint32_t exponent = bits >> 23U & 0xffU;
  if (exponent < k_bias_difference) {
    return 0;
  }
  if (exponent > k_bias_difference + 127) {
    return k_largest | sign;
  }
  return (bits | 0x800000U) << 8U | sign | (exponent - k_bias_difference);
}

/// A number of the format, which has to be zero or normalised, as a float: exact.
constexpr float from_ffp(std::uint32_t number) {
  if (number == 0) {
    return 0;
  }
  const std::uint32_t bits =
      (number & k_sign) << 24U | ((number & 0x7fU) + 62) << 23U | (number >> 8U & 0x7fffffU);
  return __builtin_bit_cast(float, bits);
}

}  // namespace maquette::firmware::maquette_ffp
