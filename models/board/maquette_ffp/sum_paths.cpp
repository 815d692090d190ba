#include "models/board/maquette_ffp/addition_paths.hpp"

namespace maquette::models::routine_cost {

namespace {

// A sum, its carry, and below it the byte that the shift put there.
struct Sum {
  std::uint32_t mantissa = 0;
  std::uint32_t byte = 0;
  bool carry = false;
};

Sum sum_of(const Alignment& alignment) {
  const std::uint32_t shifted = alignment.small >> alignment.distance;
  Sum sum;
  sum.byte = shifted & 0xffU;
  sum.mantissa = alignment.large + mantissa(shifted);
  sum.carry = sum.mantissa < alignment.large;
  return sum;
}

// What rounds is decided by the byte's highest bit, and by the others whether it is a tie.
struct Rounding {
  std::uint32_t mantissa = 0;
  std::uint32_t byte = 0;

  [[nodiscard]] bool up() const { return (byte & 0x80U) != 0; }
  [[nodiscard]] bool tie() const { return (byte & 0x7fU) == 0; }
  [[nodiscard]] bool odd() const { return (mantissa & 0x100U) != 0; }
};

Rounding after_carry(const Sum& sum) {
  const std::uint32_t rotated = 0x80000000U | sum.mantissa >> 1U;
  return {mantissa(rotated), (rotated & 0x80U) | sum.byte >> 1U};
}

// Up to the branch that finds an exponent beyond the last.
RoutineCost carried(const Alignment& alignment) {
  const bool overflow = exponent(alignment.result_byte) == 127;
  const bool is_negative = negative(alignment.result_byte);
  const RoutineCost cost = k_taken + alignment.sign() + words(2) + long_shift(1) + words(1) +
                           overflow_branches(overflow, is_negative);
  if (!overflow) {
    return cost;
  }
  return cost + k_taken + words(1) + branch(!is_negative) + largest(is_negative);
}

RoutineCost near_carry(const Alignment& alignment, const Sum& sum) {
  RoutineCost cost = carried(alignment);
  if (exponent(alignment.result_byte) == 127) {
    return cost;
  }
  const Rounding rounding = after_carry(sum);
  cost += words(1) + branch(rounding.up());
  if (!rounding.up()) {
    return cost + words(1) + k_return;
  }
  cost += branch(rounding.tie()) + words(1);
  if (rounding.tie()) {
    cost += k_bit_test + branch(rounding.odd());
  }
  if (rounding.tie() && !rounding.odd()) {
    return cost + k_return;
  }
  return cost + next_mantissa(rounding.mantissa, alignment.result_byte + 1);
}

RoutineCost near_sum(const Alignment& alignment) {
  const Sum sum = sum_of(alignment);
  const RoutineCost shifted =
      words(alignment.reversed ? 1 : 2) + long_shift(alignment.distance) + words(2) + k_long;
  if (sum.carry) {
    return shifted + near_carry(alignment, sum);
  }
  const Rounding rounding{sum.mantissa, sum.byte};
  RoutineCost cost = shifted + k_not_taken + alignment.sign() + words(1) + branch(rounding.up());
  if (!rounding.up()) {
    return cost + k_return;
  }
  cost += branch(rounding.tie());
  if (rounding.tie()) {
    cost += k_bit_test + branch(rounding.odd());
  }
  if (rounding.tie() && !rounding.odd()) {
    return cost + k_return;
  }
  return cost + next_mantissa(rounding.mantissa, alignment.result_byte);
}

RoutineCost far_carry(const Alignment& alignment, const Sum& sum) {
  RoutineCost cost = carried(alignment);
  if (exponent(alignment.result_byte) == 127) {
    return cost;
  }
  const Rounding rounding = after_carry(sum);
  cost += words(1) + branch(rounding.up());
  if (!rounding.up()) {
    return cost + words(1) + k_return;
  }
  cost += branch(!rounding.tie());
  if (rounding.tie()) {
    const bool lost = loses(alignment.small | sum.byte, alignment.distance);
    cost += isolation(alignment.distance) + branch(lost);
    if (!lost) {
      cost += k_bit_test + branch(!rounding.odd());
    }
    if (!lost && !rounding.odd()) {
      return cost + words(1) + k_return;
    }
  }
  return cost + words(1) + k_taken + next_mantissa(rounding.mantissa, alignment.result_byte + 1);
}

RoutineCost far_sum(const Alignment& alignment) {
  const Sum sum = sum_of(alignment);
  const RoutineCost shifted =
      words(alignment.reversed ? 2 : 3) + long_shift(alignment.distance) + words(2) + k_long;
  if (sum.carry) {
    return shifted + far_carry(alignment, sum);
  }
  const Rounding rounding{sum.mantissa, sum.byte};
  RoutineCost cost = shifted + k_not_taken + alignment.sign() + words(1) + branch(rounding.up());
  if (!rounding.up()) {
    return cost + k_return;
  }
  cost += branch(!rounding.tie());
  if (rounding.tie()) {
    const bool lost = loses(alignment.small, alignment.distance);
    cost += isolation(alignment.distance) + branch(lost);
    if (!lost) {
      cost += k_bit_test + branch(rounding.odd());
    }
    if (!lost && !rounding.odd()) {
      return cost + k_return;
    }
  }
  return cost + next_mantissa(rounding.mantissa, alignment.result_byte);
}

}  // namespace

RoutineCost sum(const Alignment& alignment) {
  const RoutineCost cost = comparison_of_exponents(alignment);
  if (!alignment.is_far()) {
    return cost + near_sum(alignment);
  }
  if (alignment.distance <= 24) {
    return cost + k_immediate + k_taken + far_sum(alignment);
  }
  return cost + k_immediate + k_not_taken + words(alignment.reversed ? 1 : 0) + alignment.sign() +
         k_return;
}

}  // namespace maquette::models::routine_cost
