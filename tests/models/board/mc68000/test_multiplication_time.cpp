#include <algorithm>
#include <random>

#include "models/board/mc68000/multiplication_time.hpp"
#include "tests/catch.hpp"

namespace {

using namespace maquette::models::mc68000;

TEST_CASE("MULU takes two cycles for each bit that is set") {
  CHECK(unsigned_multiplication_cycles(0) == 0);
  CHECK(unsigned_multiplication_cycles(0x8001) == 4);
  CHECK(unsigned_multiplication_cycles(0xffff) == 32);
}

TEST_CASE("MULS takes two cycles for each change between bits") {
  CHECK(signed_multiplication_cycles(0) == 0);
  CHECK(signed_multiplication_cycles(0xffff) == 2);  // the appended zero
  CHECK(signed_multiplication_cycles(0x8000) == 2);
  CHECK(signed_multiplication_cycles(0x5555) == 32);
  CHECK(signed_multiplication_cycles(0xaaaa) == 30);
}

// The restoring division as the microcode steps through it, in the words of its analysis: a partial
// remainder of 17 bits, and so many cycles for each quotient bit but the last.
unsigned stepwise_cycles(std::uint32_t dividend, std::uint32_t divisor) {
  if (dividend / divisor > 0xffff) return 10;
  unsigned cycles = 76;
  std::uint64_t remainder = dividend >> 16U;
  for (unsigned bit = 15; bit > 0; --bit) {
    remainder = remainder << 1U | (dividend >> bit & 1U);
    if (remainder > 0xffff) {
      remainder -= divisor;
    } else if (remainder >= divisor) {
      remainder -= divisor;
      cycles += 2;
    } else {
      cycles += 4;
    }
  }
  return cycles;
}

TEST_CASE("DIVU takes what its steps take, 76 to 136 cycles, or 10") {
  std::mt19937 random(1);
  unsigned shortest = 1000;
  unsigned longest = 0;
  for (unsigned count = 0; count < 200'000; ++count) {
    const auto divisor = static_cast<std::uint16_t>(random() >> (16 + random() % 16) | 1U);
    const std::uint32_t dividend =
        count % 8 == 0 ? static_cast<std::uint32_t>(random())
                       : static_cast<std::uint32_t>(random() % (std::uint64_t{divisor} << 16U));
    const unsigned cycles = unsigned_division_cycles(dividend, divisor);
    REQUIRE(cycles == stepwise_cycles(dividend, divisor));
    if (cycles == 10) continue;
    shortest = std::min(shortest, cycles);
    longest = std::max(longest, cycles);
  }
  CHECK(unsigned_division_cycles(0, 1) == 136);
  CHECK(unsigned_division_cycles(0xffff'0000U - 1, 0xffff) == 76 + 15 * 2 - 30);
  CHECK(shortest >= 76);
  CHECK(longest == 136);
}

TEST_CASE("DIVS takes 120 to 156 cycles by signs and zeros of the quotient, or 16 or 18") {
  CHECK(signed_division_cycles(0x7fff * 0x7fff, 0x7fff) == 122);  // of 0x7fff the top bit is zero
  CHECK(signed_division_cycles(0, 1) == 150);
  CHECK(signed_division_cycles(0, -1) == 152);
  CHECK(signed_division_cycles(-1, 1) == 156);
  CHECK(signed_division_cycles(-1, -1) == 154);
  CHECK(signed_division_cycles(0x0001'0000, 1) == 16);
  CHECK(signed_division_cycles(-0x0001'0000, 1) == 18);
  CHECK(signed_division_cycles(INT32_MIN, -1) == 18);
  CHECK(signed_division_cycles(INT32_MIN, INT16_MIN) == 18);
  CHECK(signed_division_cycles(0x0000'ffff, 1) == 120);  // overflows only in its last step
}

}  // namespace
