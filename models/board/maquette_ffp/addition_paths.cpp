#include "models/board/maquette_ffp/addition_paths.hpp"

namespace maquette::models::routine_cost {

Alignment aligned(std::uint32_t d7, std::uint32_t d6, bool opposed) {
  Alignment alignment;
  alignment.opposed = opposed;
  alignment.reversed = exponent(d6) > exponent(d7);
  const std::uint32_t larger = alignment.reversed ? d6 : d7;
  const std::uint32_t smaller = alignment.reversed ? d7 : d6;
  alignment.distance = exponent(larger) - exponent(smaller);
  alignment.large = mantissa(larger);
  alignment.small = mantissa(smaller);
  alignment.result_byte = (larger & 0xffU) ^ (alignment.reversed && opposed ? 0x80U : 0U);
  return alignment;
}

RoutineCost comparison_of_exponents(const Alignment& alignment) {
  return words(2) + branch(alignment.reversed) + words(alignment.reversed ? 1 : 0) + k_immediate +
         branch(alignment.is_far());
}

RoutineCost next_mantissa(std::uint32_t mantissa, std::uint32_t result_byte) {
  const bool carries = low(mantissa) == 0xff00U;
  if (!carries) {
    return k_immediate + k_not_taken + k_return;
  }
  const bool carries_out = high(mantissa) == 0xffffU;
  const RoutineCost ripple = k_immediate + k_taken + k_taken + words(2) + branch(carries_out);
  if (!carries_out) {
    return ripple + words(1) + k_return;
  }
  const bool overflow = exponent(result_byte) == 127;
  const RoutineCost exponent_raised = ripple + k_immediate + words(2);
  return exponent_raised + overflow_branches(overflow, negative(result_byte)) +
         (overflow ? largest(negative(result_byte)) : k_return);
}

}  // namespace maquette::models::routine_cost
