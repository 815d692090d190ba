#pragma once

#include <cstdint>

#include "firmware/arithmetic/maquette_ffp/format.hpp"

namespace maquette::tests {

/// 64 random bits a time (xorshift64*), fast enough for millions of operands.
class Bits {
 public:
  explicit Bits(std::uint64_t seed) : state_(seed * 2 + 1) {}

  std::uint64_t next() {
    state_ ^= state_ >> 12U;
    state_ ^= state_ << 25U;
    state_ ^= state_ >> 27U;
    return state_ * 0x2545f4914f6cdd1dU;
  }

  /// 0 .. count - 1.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((next() >> 32U) * count >> 32U);
  }

 private:
  std::uint64_t state_;
};

inline constexpr std::uint32_t k_mantissa_top = 0x800000;

inline std::uint32_t ffp_number(std::uint32_t mantissa, std::uint32_t exponent, bool negative) {
  return mantissa << 8U | (negative ? firmware::maquette_ffp::k_sign : 0U) | (exponent & 0x7fU);
}

/// A mantissa of random bits, or one of few or of many ones, where carries and ties are.
inline std::uint32_t any_mantissa(Bits& bits) {
  const std::uint32_t random = static_cast<std::uint32_t>(bits.next() >> 41U);
  const std::uint32_t places = bits.below(23);
  switch (bits.below(8)) {
    case 0:
      return k_mantissa_top;
    case 1:
      return 0xffffff;
    case 2:
      return k_mantissa_top | 1U << places;
    case 3:
      return 0xffffffU << places & 0xffffffU;
    case 4:
      return k_mantissa_top | random >> places;
    default:
      return k_mantissa_top | random;
  }
}

/// A number of |x| = 2^-4 .. 2^4, as the costs are stated for.
inline std::uint32_t ordinary_number(Bits& bits) {
  const auto mantissa = k_mantissa_top | static_cast<std::uint32_t>(bits.next() >> 41U);
  return ffp_number(mantissa, 61 + bits.below(8), bits.below(2) != 0);
}

/// A number of any exponent, the limits and one often, and zero.
inline std::uint32_t any_number(Bits& bits) {
  const std::uint32_t near = bits.below(3);
  std::uint32_t exponent = bits.below(128);
  switch (bits.below(8)) {
    case 0:
      return 0;
    case 1:
      exponent = near;
      break;
    case 2:
      exponent = 127 - near;
      break;
    case 3:
      exponent = 63 + near;
      break;
    default:
      break;
  }
  return ffp_number(any_mantissa(bits), exponent, bits.below(2) != 0);
}

/// A number near another: of the same exponent and nearly the same mantissa.
inline std::uint32_t number_near(Bits& bits, std::uint32_t other) {
  if (other == 0) return any_number(bits);
  const std::uint32_t mantissa = ((other >> 8U) + bits.below(9) - 4) | k_mantissa_top;
  return ffp_number(mantissa & 0xffffffU, other, bits.below(2) != 0);
}

/// A number whose exponent is at most 32 less than that of another.
inline std::uint32_t number_below(Bits& bits, std::uint32_t other) {
  const std::uint32_t distance = bits.below(33);
  const std::uint32_t exponent = other & 0x7fU;
  return ffp_number(any_mantissa(bits), exponent - (distance < exponent ? distance : exponent),
                    bits.below(2) != 0);
}

/// A number whose product with another has a mantissa next to a power of two.
inline std::uint32_t number_of_round_product(Bits& bits, std::uint32_t other) {
  if (other == 0) return any_number(bits);
  const std::uint64_t mantissa = (std::uint64_t{1} << 47U) / (other >> 8U) + bits.below(3) - 1;
  return ffp_number((static_cast<std::uint32_t>(mantissa) | k_mantissa_top) & 0xffffffU,
                    128U - (other & 0x7fU) + bits.below(5) - 2, bits.below(2) != 0);
}

/// An integer of any length, often next to a power of two.
inline std::uint32_t any_integer(Bits& bits) {
  const auto random = static_cast<std::uint32_t>(bits.next() >> 32U);
  const bool round = bits.below(4) == 0;
  const std::uint32_t places = bits.below(32);
  const std::uint32_t magnitude = round ? (1U << places) + bits.below(5) - 2 : random >> places;
  return bits.below(2) != 0 ? 0U - magnitude : magnitude;
}

struct Operands {
  std::uint32_t d7 = 0;
  std::uint32_t d6 = 0;
};

/// Two ordinary numbers, two of any kind, or two where rounding or cancellation is at its limits.
inline Operands any_operands(Bits& bits) {
  Operands operands{any_number(bits), any_number(bits)};
  switch (bits.below(8)) {
    case 0:
    case 1:
      return {ordinary_number(bits), ordinary_number(bits)};
    case 2:
      operands.d6 = number_near(bits, operands.d7);
      break;
    case 3:
      operands.d6 = number_below(bits, operands.d7);
      break;
    case 4:
      operands.d7 = number_below(bits, operands.d6);
      break;
    case 5:
      operands.d6 = number_of_round_product(bits, operands.d7);
      break;
    default:
      break;
  }
  return operands;
}

}  // namespace maquette::tests
