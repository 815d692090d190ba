#include "models/board/mc68000/multiplication_time.hpp"

#include <cstdlib>

namespace maquette::models::mc68000 {

namespace {

constexpr unsigned k_quotient_bits = 16;

unsigned ones(std::uint32_t bits) { return static_cast<unsigned>(__builtin_popcount(bits)); }

}  // namespace

unsigned unsigned_multiplication_cycles(std::uint16_t source) { return 2 * ones(source); }

unsigned signed_multiplication_cycles(std::uint16_t source) {
  const std::uint32_t appended = std::uint32_t{source} << 1U;
  return 2 * ones((appended ^ source) & 0xffffU);
}

// Each but the last quotient bit takes four cycles, or six when it is found by comparison, or eight
// when it is zero.
unsigned unsigned_division_cycles(std::uint32_t dividend, std::uint16_t divisor) {
  constexpr unsigned k_overflow = 10;
  constexpr unsigned k_without_extra = 76;
  if (dividend >> 16U >= divisor) {
    return k_overflow;
  }
  const std::uint32_t aligned = std::uint32_t{divisor} << 16U;
  unsigned extra = 0;
  for (unsigned bit = 1; bit < k_quotient_bits; ++bit) {
    const bool carried = dividend >> 31U != 0;
    dividend <<= 1U;
    const bool fits = carried || dividend >= aligned;
    if (fits) {
      dividend -= aligned;
    }
    if (!carried) {
      extra += fits ? 2 : 4;
    }
  }
  return k_without_extra + extra;
}

// The microcode divides magnitudes; the signs of the operands lengthen it, and so does each zero
// among the quotient's upper fifteen bits.
unsigned signed_division_cycles(std::int32_t dividend, std::int16_t divisor) {
  constexpr unsigned k_overflow = 16;
  constexpr unsigned k_without_extra = 120;
  const bool negative = dividend < 0;
  const auto magnitude =
      negative ? 0U - static_cast<std::uint32_t>(dividend) : static_cast<std::uint32_t>(dividend);
  const auto divisor_magnitude = static_cast<std::uint32_t>(std::abs(int{divisor}));
  if (magnitude >> 16U >= divisor_magnitude) {
    return k_overflow + (negative ? 2 : 0);
  }
  const unsigned sign_cycles = divisor < 0 ? (negative ? 4 : 2) : (negative ? 6 : 0);
  const std::uint32_t quotient = magnitude / divisor_magnitude;
  const unsigned zeros = k_quotient_bits - 1 - ones(quotient & 0xfffeU);
  return k_without_extra + sign_cycles + 2 * zeros;
}

}  // namespace maquette::models::mc68000
