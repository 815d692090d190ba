#pragma once

#include <cstdint>

#include "firmware/arithmetic/maquette_ffp/format.hpp"

namespace maquette::costs {

/// Random operands, the same on every host (xorshift64*).
class RandomOperands {
 public:
  /// A number of |x| = 2^-4 .. 2^4 and either sign, each power of two as often as the others.
  std::uint32_t number() {
    const std::uint64_t bits = next();
    return 0x80000000U | static_cast<std::uint32_t>(bits >> 33U) << 8U |
           (static_cast<std::uint32_t>(bits) & firmware::maquette_ffp::k_sign) |
           (61 + static_cast<std::uint32_t>(bits >> 16U & 7U));
  }

  std::uint32_t positive_number() { return number() & ~firmware::maquette_ffp::k_sign; }

  /// In [low, high).
  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(next() >> 40U) * 0x1p-24F;
  }

  /// -999 .. 999.
  std::int32_t integer() { return static_cast<std::int32_t>(next() % 1999) - 999; }

  bool coin() { return next() >> 63U != 0; }

 private:
  std::uint64_t next() {
    state_ ^= state_ >> 12U;
    state_ ^= state_ << 25U;
    state_ ^= state_ >> 27U;
    return state_ * 0x2545f4914f6cdd1dU;
  }

  std::uint64_t state_ = 0x9e3779b97f4a7c15U;
};

}  // namespace maquette::costs
