#include "models/board/maquette_ffp/addition_paths.hpp"

namespace maquette::models::routine_cost {

namespace {

constexpr bool is_normalised(std::uint32_t bits) { return bits >> 31U != 0; }

/// The loop that shifts a difference until it is normalised, or its exponent has run out.
RoutineCost normalisation(std::uint32_t bits, unsigned exponent) {
  const RoutineCost begun = words(3) + branch(exponent == 0);
  const RoutineCost zero = words(1) + k_return;
  if (exponent == 0) {
    return begun + zero;
  }
  const auto places = static_cast<unsigned>(__builtin_clz(bits));
  const bool reached = places <= exponent;
  const unsigned shifts = reached ? places : exponent;
  RoutineCost cost = begun;
  for (unsigned i = 1; i < shifts; ++i) {
    cost += k_long + k_taken;
  }
  cost += k_long + (reached ? k_loop_left : k_loop_expired) + branch(!reached);
  return cost + (reached ? k_immediate + words(2) + k_return : zero);
}

RoutineCost same_exponent(const Alignment& alignment) {
  const RoutineCost cost = words(2) + k_long;
  const unsigned byte_exponent = exponent(alignment.result_byte);
  const std::uint32_t difference = alignment.large - alignment.small;
  if (difference == 0) {
    return cost + k_taken + words(1) + k_return;
  }
  const bool positive = alignment.large > alignment.small;
  const RoutineCost compared = cost + k_not_taken + word_branch(positive);
  if (positive) {
    return compared + normalisation(difference, byte_exponent);
  }
  const std::uint32_t opposite = 0U - difference;
  const RoutineCost turned =
      compared + k_immediate + k_long_compare + word_branch(!is_normalised(opposite));
  if (is_normalised(opposite)) {
    return turned + words(1) + k_return;
  }
  return turned + normalisation(opposite, byte_exponent);
}

RoutineCost rounded(std::uint32_t bits, std::uint32_t result_byte) {
  const std::uint32_t byte = bits & 0xffU;
  const bool up = (byte & 0x80U) != 0;
  RoutineCost cost = words(1) + branch(up);
  if (!up) {
    return cost + words(1) + k_return;
  }
  const bool tie = byte == 0x80U;
  cost += branch(tie) + words(1);
  if (tie) {
    const bool odd = (bits & 0x100U) != 0;
    cost += k_bit_test + branch(odd);
    if (!odd) {
      return cost + k_return;
    }
    cost += words(1);
  }
  return cost + next_mantissa(mantissa(bits), result_byte);
}

RoutineCost near_difference(const Alignment& alignment) {
  const std::uint32_t shifted = alignment.small >> alignment.distance;
  RoutineCost cost = words(alignment.reversed ? 1 : 2) + long_shift(alignment.distance);
  if (alignment.reversed) {
    cost += words(2) + alignment.sign() + words(1) + k_long + words(1);
  } else {
    cost += branch(is_normalised(shifted));
    if (is_normalised(shifted)) {
      return cost + same_exponent(alignment);
    }
    cost += words(2) + k_long;
  }
  const std::uint32_t bits = alignment.large - shifted;
  cost += branch(!is_normalised(bits));
  if (is_normalised(bits)) {
    return cost + rounded(bits, alignment.result_byte);
  }
  const std::uint32_t doubled = bits << 1U;
  cost += k_long + branch(!is_normalised(doubled));
  if (is_normalised(doubled)) {
    return cost + words(1) + rounded(doubled, alignment.result_byte - 1);
  }
  cost += words(2) + word_branch(doubled != 0);
  if (doubled == 0) {
    return cost + words(1) + k_return;
  }
  return cost + normalisation(doubled, exponent(alignment.result_byte) - 1);
}

RoutineCost far_rounded(const Alignment& alignment, std::uint32_t bits, std::uint32_t result_byte) {
  const std::uint32_t byte = bits & 0xffU;
  const bool up = (byte & 0x80U) != 0;
  RoutineCost cost = words(1) + branch(up);
  if (!up) {
    return cost + words(1) + k_return;
  }
  const bool tie = byte == 0x80U;
  cost += branch(!tie);
  if (tie) {
    const bool lost = loses(alignment.small, alignment.distance);
    cost += words(2) + isolation(alignment.distance) + branch(lost);
    if (lost) {
      return cost + words(1) + k_return;
    }
    const bool odd = (bits & 0x100U) != 0;
    cost += words(1) + k_bit_test + branch(odd);
    if (!odd) {
      return cost + words(1) + k_return;
    }
  }
  return cost + words(1) + next_mantissa(mantissa(bits), result_byte);
}

RoutineCost far_difference(const Alignment& alignment) {
  RoutineCost cost = long_shift(alignment.distance) + k_long;
  cost += alignment.reversed ? words(6) + alignment.sign() : words(5);
  const std::uint32_t bits = alignment.large - (alignment.small >> alignment.distance);
  cost += branch(is_normalised(bits) == alignment.reversed);
  if (is_normalised(bits)) {
    return cost + far_rounded(alignment, bits, alignment.result_byte);
  }
  return cost + k_long + words(1) + k_taken +
         far_rounded(alignment, bits << 1U, alignment.result_byte - 1);
}

}  // namespace

RoutineCost difference(const Alignment& alignment) {
  const RoutineCost cost = comparison_of_exponents(alignment);
  if (!alignment.is_far()) {
    return cost + near_difference(alignment);
  }
  if (alignment.distance <= 25) {
    return cost + k_immediate + k_taken + far_difference(alignment);
  }
  return cost + k_immediate + k_not_taken + words(alignment.reversed ? 1 : 0) + alignment.sign() +
         k_return;
}

}  // namespace maquette::models::routine_cost
