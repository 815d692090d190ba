#pragma once

#include "firmware/board/number.hpp"

/// The numbers of a board's program in the FFP format (maquette_ffp/): what differs from a float is
/// the range, and how a number is made of its parts.
namespace maquette::firmware {

using BoardNumber = Number<FfpFormat>;

namespace elementary {

/// One is 0.1 (binary) times two.
inline constexpr std::uint32_t k_exponent_of_one = 65;

template <>
struct Format<BoardNumber> : Format<float> {
  static constexpr int bias = 63;  ///< numbers of 2^63 and more are beyond the range
};

template <>
inline BoardNumber power_of_two<BoardNumber>(int n) {
  return BoardNumber::of_bits(0x80000000U | (static_cast<std::uint32_t>(n) + k_exponent_of_one));
}

template <>
inline BoardNumber split<BoardNumber>(BoardNumber value, int& exponent) {
  constexpr std::uint32_t k_mask = 0x7F;
  exponent = static_cast<int>(value.bits & k_mask) - static_cast<int>(k_exponent_of_one);
  BoardNumber mantissa = BoardNumber::of_bits((value.bits & ~k_mask) | k_exponent_of_one);
  if (mantissa > constant<BoardNumber>(1.41421356237309504880)) {
    mantissa *= constant<BoardNumber>(0.5);
    ++exponent;
  }
  return mantissa;
}

}  // namespace elementary

}  // namespace maquette::firmware

template <>
class std::numeric_limits<maquette::firmware::BoardNumber> : public std::numeric_limits<float> {
 public:
  static constexpr float min() { return 0x1p-65F; }
  static constexpr float max() { return 0x1.fffffep62F; }
};
