#pragma once

#include <cstdint>

#include "firmware/arithmetic/maquette_ffp/format.hpp"

/// The formats in which a board's program may hold its numbers, all of 32 bits.
namespace maquette::firmware {

enum class NumberFormat : std::uint8_t { ffp, ieee_single };

/// Motorola's Fast Floating Point, as maquette_ffp/format.hpp tells. Zero has no sign.
struct FfpFormat {
  static constexpr std::uint32_t bits_of(float value) { return maquette_ffp::to_ffp(value); }
  static constexpr float value_of(std::uint32_t bits) { return maquette_ffp::from_ffp(bits); }

  static constexpr std::uint32_t negative(std::uint32_t bits) {
    return bits == 0 ? 0 : bits ^ maquette_ffp::k_sign;
  }
  static constexpr std::uint32_t magnitude(std::uint32_t bits) {
    return bits & ~maquette_ffp::k_sign;
  }
};

/// IEEE 754 single precision, a float of the host as it is: zeros have a sign, there are denormal
/// numbers, infinities and what is not a number.
struct IeeeSingleFormat {
  static constexpr std::uint32_t k_sign = 0x80000000;

  static constexpr std::uint32_t bits_of(float value) {
    return __builtin_bit_cast(std::uint32_t, value);
  }
  static constexpr float value_of(std::uint32_t bits) { return __builtin_bit_cast(float, bits); }

  static constexpr std::uint32_t negative(std::uint32_t bits) { return bits ^ k_sign; }
  static constexpr std::uint32_t magnitude(std::uint32_t bits) { return bits & ~k_sign; }
};

/// The bits of a number in a format.
constexpr std::uint32_t bits_in(NumberFormat format, float value) {
  return format == NumberFormat::ffp ? FfpFormat::bits_of(value) : IeeeSingleFormat::bits_of(value);
}

}  // namespace maquette::firmware
