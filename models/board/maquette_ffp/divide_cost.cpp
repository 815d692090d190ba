#include "models/board/maquette_ffp/routine_cost.hpp"

namespace maquette::models {

using namespace routine_cost;

namespace {

RoutineCost next(std::uint32_t bits) {
  const bool carries = low(bits) == 0xff00U;
  return k_immediate + branch(carries) + (carries ? k_long_add : RoutineCost{}) + words(1) +
         k_return;
}

// The quotient as the routine has it before it is rounded: too large by less than two units.
struct Quotient {
  std::uint32_t high = 0;
  std::uint32_t low = 0;
  std::uint32_t remainder = 0;

  [[nodiscard]] std::uint32_t bits() const { return high << 16U | low; }
};

RoutineCost doubtful(const Quotient& quotient, std::uint32_t divisor) {
  const bool odd = (quotient.low & 1U) != 0;
  const std::uint32_t half = quotient.low & 0xfffeU;
  RoutineCost cost = words(2) + k_low_bit_clear + branch(!odd) + words(odd ? 2 : 0) + words(2) +
                     multiplication(half) + words(1) + k_long;
  const std::uint64_t left = (std::uint64_t{quotient.remainder} + (odd ? high(divisor) : 0U))
                             << 16U;
  const std::uint32_t right = half * low(divisor);
  const bool carries = left >> 32U != 0;
  cost += branch(carries);
  if (!carries) {
    cost += k_long_compare + branch(left < right);
  }
  return cost + (left < right ? words(1) + k_return
                              : next(quotient.bits() << (quotient.high >> 15U == 0 ? 1U : 0U)));
}

RoutineCost normalised_result(const Quotient& quotient, std::uint32_t divisor) {
  const std::uint32_t byte = quotient.low & 0xffU;
  const RoutineCost cost = words(1) + branch(byte >= 0x80U);
  if (byte < 0x80U) {
    return cost + words(3) + k_return;
  }
  const bool is_doubtful = byte < 0x82U;
  const RoutineCost checked = cost + words(1) + branch(is_doubtful);
  if (!is_doubtful) {
    return checked + words(2) + next(quotient.bits());
  }
  return checked + words(1) + shift(1) + k_low_bit_set + words(2) + doubtful(quotient, divisor);
}

RoutineCost shifted_result(const Quotient& quotient, std::uint32_t divisor) {
  const std::uint32_t bits = quotient.bits() << 1U;
  const std::uint32_t byte = bits & 0xffU;
  const RoutineCost cost = words(1) + branch(byte >= 0x80U);
  if (byte < 0x80U) {
    return cost + words(2) + k_return;
  }
  const bool is_doubtful = byte < 0x84U;
  const RoutineCost checked = cost + words(1) + branch(is_doubtful);
  return checked + (is_doubtful ? doubtful(quotient, divisor) : words(1) + next(bits));
}

RoutineCost result(const Quotient& quotient, std::uint32_t divisor, unsigned raised_exponent,
                   bool is_negative) {
  const bool shifts = quotient.high >> 15U == 0;
  const RoutineCost cost = words(1) + branch(shifts);
  if (!shifts) {
    return cost + normalised_result(quotient, divisor);
  }
  const RoutineCost shifted = cost + words(2) + k_long + words(1);
  if (raised_exponent == 0) {
    return shifted + overflow_branches(true, !is_negative) + words(1) + k_return;
  }
  return shifted + k_not_taken + k_not_taken + shifted_result(quotient, divisor);
}

RoutineCost saturated(bool is_negative) {
  return words(1) + branch(!is_negative) + largest(is_negative);
}

// Half of the quotient is taken instead, where the range ends.
RoutineCost half(std::uint32_t d7, std::uint32_t d6) {
  const bool is_negative = negative(d7 ^ d6);
  const bool overflow = mantissa(d7) >= mantissa(d6);
  return words(1) + k_call + divide_cost(d7 - 1, d6) + words(1) +
         overflow_branches(overflow, is_negative) + (overflow ? largest(is_negative) : k_return);
}

RoutineCost out_of_range(std::uint32_t d7, std::uint32_t d6) {
  const RoutineCost cost = words(5);
  if (exponent(d7) < exponent(d6)) {
    return cost + k_taken + words(1) + k_return;
  }
  const bool just = exponent(d7) - exponent(d6) == 63;
  return cost + k_not_taken + k_immediate + branch(!just) +
         (just ? half(d7, d6) : saturated(negative(d7 ^ d6)));
}

// The division, and what it takes up to its result.
RoutineCost quotient_of(std::uint32_t d7, std::uint32_t d6, Quotient& quotient) {
  const std::uint32_t dividend = mantissa(d7) >> 1U;
  const std::uint32_t divisor = mantissa(d6);
  RoutineCost cost = words(1) + long_shift(1) + words(1) + division(dividend, high(divisor));
  quotient.high = dividend / high(divisor);
  cost += words(4) + multiplication(quotient.high) + words(1) + k_long;
  std::int64_t rest =
      (std::int64_t{dividend % high(divisor)} << 16) - std::int64_t{quotient.high} * low(divisor);
  cost += branch(rest >= 0);
  if (rest < 0) {
    rest += divisor;
    --quotient.high;
    cost += words(3) + k_long + branch(rest >= 0);
    if (rest < 0) {
      rest += divisor;
      --quotient.high;
      cost += words(1) + k_long;
    }
  }
  const auto remainder = static_cast<std::uint32_t>(rest);
  const bool overflows = high(remainder) >= high(divisor);
  cost += division(remainder, high(divisor)) + branch(overflows);
  if (overflows) {
    quotient.low = 0xffffU;
    return cost + words(1) + k_taken;
  }
  quotient.low = remainder / high(divisor);
  quotient.remainder = remainder % high(divisor);
  return cost;
}

}  // namespace

RoutineCost divide_cost(std::uint32_t d7, std::uint32_t d6) {
  if (d7 == 0) {
    return words(1) + k_taken + k_return;
  }
  if (d6 == 0) {
    return words(2) + k_not_taken + k_taken + saturated(negative(d7));
  }
  const unsigned raised_exponent = exponent(d7) + 65 - exponent(d6);
  const bool in_range = raised_exponent <= 127;
  const RoutineCost entered =
      words(6) + k_not_taken + k_not_taken + k_immediate + branch(!in_range);
  if (!in_range) {
    return entered + out_of_range(d7, d6);
  }
  Quotient quotient;
  const RoutineCost divided = entered + quotient_of(d7, d6, quotient);
  return divided + result(quotient, mantissa(d6), raised_exponent, negative(d7 ^ d6));
}

}  // namespace maquette::models
