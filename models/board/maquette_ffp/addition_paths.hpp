#pragma once

#include <cstdint>

#include "models/board/maquette_ffp/routine_cost.hpp"

/// Paths through addition and subtraction, as firmware/arithmetic/maquette_ffp/magnitudes.inc,
/// sum.inc and difference.inc have them.
namespace maquette::models::routine_cost {

/// Where a sum or a difference of magnitudes begins: the exponents are compared.
struct Alignment {
  bool reversed = false;    // D6 has the larger exponent
  bool opposed = false;     // then its sign is turned
  unsigned distance = 0;    // of the exponents
  std::uint32_t large = 0;  // mantissas, in the upper 24 bits
  std::uint32_t small = 0;
  std::uint32_t result_byte = 0;  // sign and exponent of the larger

  [[nodiscard]] bool is_far() const { return distance > 7; }
  [[nodiscard]] RoutineCost sign() const {
    return reversed && opposed ? k_immediate : RoutineCost{};
  }
};

Alignment aligned(std::uint32_t d7, std::uint32_t d6, bool opposed);

/// Up to where the distance is known to be near or far.
RoutineCost comparison_of_exponents(const Alignment& alignment);

/// The isolation of what a shift by so many places loses.
constexpr RoutineCost isolation(unsigned distance) {
  return words(1) + k_immediate + long_shift(31 - distance);
}

/// Whether anything is lost but the bits that the shifted operand keeps.
constexpr bool loses(std::uint32_t small, unsigned distance) {
  return small << (31U - distance) != 0;
}

/// Adds one in the last place of a result's mantissa, and returns.
RoutineCost next_mantissa(std::uint32_t mantissa, std::uint32_t result_byte);

RoutineCost sum(const Alignment& alignment);
RoutineCost difference(const Alignment& alignment);

}  // namespace maquette::models::routine_cost
