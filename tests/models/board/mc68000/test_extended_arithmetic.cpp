#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

// Z is cleared by a result that is not zero, and else stays.
unsigned sticky(unsigned codes, unsigned before) {
  return (codes & 4U) != 0 ? (codes & ~4U) | (before & 4U) : codes;
}

TEST_CASE("ADDX and SUBX carry X and only ever clear Z") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < 30'000; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    const unsigned extend = codes >> 4U;
    board.d(1) = source;
    board.d(0) = destination;
    board.set_codes(codes);
    board.execute({0xd101U | size_code(bits)});
    const Expected sum = expected_sum(destination, source, extend, bits);
    REQUIRE(board.d(0) == replaced(destination, sum.result, bits));
    REQUIRE(board.codes() == sticky(sum.codes, codes));
    board.d(0) = destination;
    board.set_codes(codes);
    board.execute({0x9101U | size_code(bits)});
    const Expected rest = expected_difference(destination, source, extend, bits);
    REQUIRE(board.d(0) == replaced(destination, rest.result, bits));
    REQUIRE(board.codes() == sticky(rest.codes, codes));
  }
}

TEST_CASE("numbers of many words are added and subtracted in memory, downwards") {
  SmallBoard board;
  Operands operands(2);
  for (unsigned count = 0; count < 2'000; ++count) {
    const std::uint64_t a = std::uint64_t{operands.next()} << 32U | operands.next();
    const std::uint64_t b = std::uint64_t{operands.next()} << 32U | operands.next();
    for (const unsigned pattern : {0xd188U, 0x9188U}) {  // ADDX.L, SUBX.L -(A0),-(A1)
      board.poke(0x4000, 4, static_cast<std::uint32_t>(a >> 32U));
      board.poke(0x4004, 4, static_cast<std::uint32_t>(a));
      board.poke(0x5000, 4, static_cast<std::uint32_t>(b >> 32U));
      board.poke(0x5004, 4, static_cast<std::uint32_t>(b));
      board.a(1) = 0x4008;
      board.a(0) = 0x5008;
      board.set_codes(4);
      board.execute({pattern | 1U << 9U});
      board.execute({pattern | 1U << 9U});
      const std::uint64_t result = pattern == 0xd188 ? a + b : a - b;
      const bool carry = pattern == 0xd188 ? result < a : a < b;
      REQUIRE(board.peek(0x4000, 4) == result >> 32U);
      REQUIRE(board.peek(0x4004, 4) == (result & 0xffff'ffffU));
      REQUIRE(board.a(0) == 0x5000);
      REQUIRE(board.a(1) == 0x4000);
      REQUIRE((board.codes() & 4U) == (result == 0 ? 4U : 0U));
      REQUIRE((board.codes() & 17U) == (carry ? 17U : 0U));
    }
  }
}

unsigned decimal(unsigned number) { return number / 10 << 4U | number % 10; }

TEST_CASE("ABCD, SBCD and NBCD compute with all pairs of decimal digits") {
  SmallBoard board;
  for (unsigned pair = 0; pair < 20'000; ++pair) {
    const unsigned a = pair / 2 / 100;
    const unsigned b = pair / 2 % 100;
    const unsigned extend = pair % 2;
    for (const unsigned word : {0xc101U, 0x8101U, 0x4801U}) {
      board.d(0) = decimal(a) | 0xabcdef00U;
      board.d(1) = decimal(b) | 0x12345600U;
      board.set_codes(extend << 4U | 4U);
      board.execute({word});
      const unsigned first = word == 0x4801 ? 0 : a;
      const unsigned exact = word == 0xc101 ? a + b + extend : first + 100 - b - extend;
      const bool carry = (exact >= 100) == (word == 0xc101);
      REQUIRE((word == 0x4801 ? board.d(1) : board.d(0)) ==
              (decimal(exact % 100) | (word == 0x4801 ? 0x12345600U : 0xabcdef00U)));
      REQUIRE((board.codes() & 17U) == (carry ? 17U : 0U));
      REQUIRE((board.codes() & 4U) == (exact % 100 == 0 ? 4U : 0U));
    }
  }
}

TEST_CASE("decimal digits in memory, from the end") {
  SmallBoard board;
  board.poke(0x4000, 4, 0x09999999);
  board.poke(0x5000, 4, 0x00000001);
  board.a(1) = 0x4004;
  board.a(0) = 0x5004;
  board.set_codes(4);
  for (unsigned byte = 0; byte < 4; ++byte) board.execute({0xc308});  // ABCD -(A0),-(A1)
  CHECK(board.peek(0x4000, 4) == 0x10000000);
  CHECK(board.codes() % 8 == 0);  // Z is cleared, no carry
}

TEST_CASE("CMPM compares and moves both registers upwards") {
  SmallBoard board;
  Operands operands(3);
  for (unsigned count = 0; count < 6'000; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    board.poke(0x4000, bits / 8, destination);
    board.poke(0x5000, bits / 8, source);
    board.a(3) = 0x4000;
    board.a(2) = 0x5000;
    board.set_codes(16);
    board.execute({0xb108U | 3U << 9U | size_code(bits) | 2U});
    REQUIRE(board.codes() ==
            (16U | (expected_difference(destination, source, 0, bits).codes & 15U)));
    REQUIRE(board.a(3) == 0x4000 + bits / 8);
    REQUIRE(board.a(2) == 0x5000 + bits / 8);
  }
}

TEST_CASE("EXG exchanges registers of either kind") {
  SmallBoard board;
  board.d(1) = 1;
  board.d(2) = 2;
  board.a(1) = 11;
  board.a(2) = 12;
  board.set_codes(0x15);
  board.execute({0xc342});  // EXG D1,D2
  CHECK(board.d(1) == 2);
  CHECK(board.d(2) == 1);
  board.execute({0xc34a});  // EXG A1,A2
  CHECK(board.a(1) == 12);
  CHECK(board.a(2) == 11);
  board.execute({0xc38a});  // EXG D1,A2
  CHECK(board.d(1) == 11);
  CHECK(board.a(2) == 2);
  CHECK(board.codes() == 0x15);
}

}  // namespace
