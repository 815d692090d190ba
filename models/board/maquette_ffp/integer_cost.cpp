#include "models/board/maquette_ffp/routine_cost.hpp"

namespace maquette::models {

using namespace routine_cost;

namespace {

// The loop that shifts until the highest bit is set, entered by a test of it.
RoutineCost shifts(unsigned places, RoutineCost step) {
  RoutineCost cost = words(1) + (places == 0 ? k_loop_left : k_taken);
  for (unsigned i = 1; i < places; ++i) {
    cost += step + k_taken;
  }
  return cost + (places == 0 ? RoutineCost{} : step + k_loop_left);
}

unsigned leading_zeros(std::uint32_t bits) { return static_cast<unsigned>(__builtin_clz(bits)); }

RoutineCost small_integer(std::uint32_t magnitude) {
  const bool byte = magnitude <= 0xffU;
  RoutineCost cost = k_immediate + branch(!byte);
  if (byte) {
    magnitude <<= 8U;
    cost += shift(8) + words(1);
  }
  const bool nibble = magnitude <= 0xfffU;
  cost += k_immediate + branch(!nibble);
  if (nibble) {
    magnitude <<= 4U;
    cost += shift(4) + words(1);
  }
  return cost + shifts(leading_zeros(magnitude) - 16, words(1)) + words(2) + k_return;
}

RoutineCost rounded_integer(std::uint32_t magnitude) {
  const unsigned places = leading_zeros(magnitude);
  RoutineCost cost = words(1) + k_taken;
  for (unsigned i = 0; i < places; ++i) {
    cost += k_taken + k_long;
  }
  cost += k_loop_left + words(1);
  const std::uint32_t bits = magnitude << places;
  const bool up = (bits & 0x80U) != 0;
  cost += branch(up);
  if (!up) {
    return cost + words(1) + k_return;
  }
  const bool tie = (bits & 0xffU) == 0x80U;
  cost += branch(!tie);
  if (tie) {
    const bool even = (bits & 0x100U) == 0;
    cost += k_bit_test + branch(even);
    if (even) {
      return cost + words(1) + k_return;
    }
  }
  const bool carries = bits >> 8U == 0xffffffU;
  return cost + words(1) + k_long_add + branch(carries) +
         (carries ? words(1) + k_high_bit_set : RoutineCost{}) + k_return;
}

RoutineCost large_integer(std::uint32_t magnitude) {
  const bool rounds = magnitude > 0xffffffU;
  const RoutineCost cost = k_immediate + k_long_compare_with + branch(rounds);
  if (rounds) {
    return cost + rounded_integer(magnitude);
  }
  return cost + long_shift(8) + words(1) + shifts(leading_zeros(magnitude) - 8, k_long) + words(1) +
         k_return;
}

}  // namespace

RoutineCost from_integer_cost(std::uint32_t integer) {
  if (integer == 0) {
    return words(1) + k_taken + k_return;
  }
  const bool is_negative = integer >> 31U != 0;
  const std::uint32_t magnitude = is_negative ? 0U - integer : integer;
  const bool large = magnitude > 0xffffU;
  const RoutineCost entered = words(1) + k_not_taken + branch(is_negative) + words(1) +
                              (is_negative ? k_long_compare + k_taken : RoutineCost{});
  return entered + k_long_compare_with + branch(large) +
         (large ? large_integer(magnitude) : small_integer(magnitude));
}

RoutineCost to_integer_cost(std::uint32_t d7) {
  const unsigned power = exponent(d7);
  const RoutineCost entered = words(1) + branch(negative(d7)) + words(2) + branch(power > 80);
  const RoutineCost sign = negative(d7) ? k_long_compare : RoutineCost{};
  if (power > 80) {
    const bool too_large = power >= 96;
    const RoutineCost largest_integer = words(1) + long_shift(1) + k_return;
    return entered + words(1) + k_immediate + branch(too_large) +
           (too_large ? largest_integer : long_shift(96 - power) + sign + k_return);
  }
  const bool none = power <= 64;
  return entered + k_immediate + branch(none) +
         (none ? words(1) + k_return : words(2) + shift(80 - power) + sign + k_return);
}

}  // namespace maquette::models
