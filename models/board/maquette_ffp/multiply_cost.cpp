#include "models/board/maquette_ffp/routine_cost.hpp"

namespace maquette::models {

using namespace routine_cost;

namespace {

// Two mantissas of 16 and 8 bits, the latter in the upper half of a word, and what the routine
// knows of their product before all of it is computed.
struct Factors {
  std::uint32_t a1, a0, b1, b0;

  [[nodiscard]] std::uint64_t cross() const {
    return std::uint64_t{a1} * b0 + std::uint64_t{b1} * a0;
  }
  [[nodiscard]] std::uint32_t upper() const {
    return a1 * b1 + static_cast<std::uint32_t>(cross() >> 16U);
  }
  [[nodiscard]] std::uint64_t product() const {
    return (std::uint64_t{a1} * b1 << 32U) + (cross() << 16U) + std::uint64_t{a0} * b0;
  }
};

// Adds one in the last place; the exponent has room.
RoutineCost next(std::uint32_t bits) {
  const RoutineCost added = words(1) + k_immediate;
  if (low(bits) != 0xff00U) {
    return added + k_not_taken + k_return;
  }
  const bool carries_out = high(bits) == 0xffffU;
  const RoutineCost ripple = added + k_taken + words(2) + branch(carries_out);
  return ripple + (carries_out ? k_immediate + words(2) : words(1)) + k_return;
}

RoutineCost exact(const Factors& f) {
  RoutineCost cost = words(5) + multiplication(f.a0) + words(2) + multiplication(f.a1) + k_long +
                     words(3) + multiplication(f.a0) + k_long + words(6) + multiplication(f.b1) +
                     words(1) + k_long;
  std::uint64_t product = f.product();
  const bool normalised = product >> 63U != 0;
  const bool rest = (product & 0xffffffffU) != 0;
  cost += branch(normalised);
  if (!normalised) {
    cost += k_long + words(1);
    product <<= 1U;
  }
  cost += words(1) + branch(!rest) + (rest ? k_immediate : RoutineCost{});
  const auto bits = static_cast<std::uint32_t>(product >> 32U);
  const bool up = (bits & 0x80U) != 0;
  cost += words(1) + branch(!up);
  if (!up) {
    return cost + words(1) + k_return;
  }
  const bool tie = (bits & 0x7fU) == 0 && !rest;
  cost += word_branch(!tie);
  if (tie) {
    const bool odd = (bits & 0x100U) != 0;
    cost += k_bit_test + word_branch(odd);
    if (!odd) {
      return cost + words(1) + k_return;
    }
  }
  return cost + next(bits);
}

RoutineCost normalised_result(const Factors& f) {
  const std::uint32_t bits = f.upper();
  const std::uint32_t byte = bits & 0xffU;
  const bool up = byte >= 0x80U;
  const bool doubtful = byte == 0x7fU || byte == 0x80U;
  const RoutineCost cost = words(1) + branch(up) + words(up ? 0 : 1) + branch(doubtful);
  if (doubtful) {
    return cost + k_taken + exact(f);
  }
  return cost + (up ? next(bits) : words(1) + k_return);
}

RoutineCost shifted_result(const Factors& f) {
  const std::uint32_t bits = f.upper() << 1U;
  const std::uint32_t byte = bits & 0xffU;
  const bool up = byte >= 0x80U;
  const bool doubtful = byte == 0x7eU || byte == 0x80U;
  const RoutineCost cost = words(1) + branch(up) + words(up ? 0 : 1);
  if (doubtful) {
    return cost + branch(!up) + words(1) + k_taken + exact(f);
  }
  return cost + (up ? k_taken + next(bits) : k_not_taken + words(1) + k_return);
}

// A product within half a unit of the power of two that needs no shift, or beyond.
constexpr std::uint64_t k_rounds_to_unshifted = 0x7fffffc000000000U;

// Half of the product, or twice it, is taken instead, where the range ends.
RoutineCost half(std::uint32_t d7, std::uint32_t d6, const Factors& f) {
  const bool is_negative = negative(d7 ^ d6);
  const bool overflow = f.product() >= k_rounds_to_unshifted;
  return words(1) + k_call + multiply_cost(d7 - 1, d6) + words(1) +
         overflow_branches(overflow, is_negative) + (overflow ? largest(is_negative) : k_return);
}

RoutineCost twice(std::uint32_t d7, std::uint32_t d6, const Factors& f) {
  const bool is_negative = negative(d7 ^ d6);
  const bool underflow = f.product() < k_rounds_to_unshifted;
  return overflow_branches(true, !is_negative) + words(1) + k_immediate + words(2) + k_call +
         multiply_cost(d7 + 1, d6) + words(1) + overflow_branches(underflow, !is_negative) +
         (underflow ? words(1) + k_return : k_return);
}

RoutineCost out_of_range(std::uint32_t d7, std::uint32_t d6, unsigned sum, const Factors& f) {
  const RoutineCost cost = words(5) + k_immediate;
  if (sum < 192) {
    return cost + k_taken + words(1) + k_return;
  }
  if (sum == 192) {
    return cost + k_not_taken + k_not_taken + half(d7, d6, f);
  }
  const bool is_negative = negative(d7 ^ d6);
  return cost + k_not_taken + k_taken + words(1) + branch(!is_negative) + largest(is_negative);
}

}  // namespace

RoutineCost multiply_cost(std::uint32_t d7, std::uint32_t d6) {
  if (d7 == 0) {
    return words(1) + k_taken + k_return;
  }
  if (d6 == 0) {
    return words(2) + k_not_taken + k_taken + words(1) + k_return;
  }
  const Factors f{high(d7), low(d7), high(d6), low(d6)};
  const bool shifts = f.upper() >> 31U == 0;
  const unsigned sum = exponent(d7) + exponent(d6);
  const bool in_range = sum >= 64 && sum < 192;
  RoutineCost cost = words(5) + k_not_taken + k_not_taken + k_immediate + branch(!in_range);
  if (!in_range) {
    return cost + out_of_range(d7, d6, sum, f);
  }
  cost += words(3) + multiplication(f.b0) + words(2) + multiplication(f.a0) + words(2) +
          multiplication(f.b1) + words(1) + k_long + words(3) + k_long + branch(shifts);
  if (!shifts) {
    return cost + normalised_result(f);
  }
  cost += k_long + words(1);
  if (sum == 64) {
    return cost + twice(d7, d6, f);
  }
  return cost + k_not_taken + k_not_taken + shifted_result(f);
}

}  // namespace maquette::models
