#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

constexpr unsigned k_cases = 30'000;

TEST_CASE("MULU and MULS give the exact product of two words") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < k_cases; ++count) {
    const std::uint32_t a = operands.next();
    const std::uint32_t b = operands.next();
    board.d(1) = b;
    board.d(0) = a;
    board.set_codes(0x1f);
    board.execute({0xc0c1});
    const std::uint64_t product = std::uint64_t{a & 0xffffU} * (b & 0xffffU);
    REQUIRE(board.d(0) == product);
    REQUIRE(board.codes() == (16U | sign_and_zero(product, 32)));
    board.d(0) = a;
    board.execute({0xc1c1});
    const auto signed_product =
        static_cast<std::uint32_t>(signed_value(a, 16) * signed_value(b, 16));
    REQUIRE(board.d(0) == signed_product);
    REQUIRE(board.codes() == (16U | sign_and_zero(signed_product, 32)));
  }
}

TEST_CASE("DIVU gives quotient and remainder, or V and nothing else") {
  SmallBoard board;
  Operands operands(2);
  for (unsigned count = 0; count < k_cases; ++count) {
    const std::uint32_t divisor = operands.next();
    if ((divisor & 0xffffU) == 0) continue;
    const std::uint32_t dividend =
        count % 2 == 0 ? operands.next() : operands.below(divisor << 16U | 1U);
    board.d(1) = divisor;
    board.d(0) = dividend;
    board.set_codes(0x1f);
    REQUIRE(board.execute({0x80c1}).reason == StopReason::cycle_limit);
    const std::uint32_t quotient = dividend / (divisor & 0xffffU);
    if (quotient > 0xffff) {
      REQUIRE(board.d(0) == dividend);
      REQUIRE((board.codes() & 0x13U) == 0x12);
    } else {
      REQUIRE((board.d(0) & 0xffffU) == quotient);
      REQUIRE((board.d(0) >> 16U) == dividend % (divisor & 0xffffU));
      REQUIRE(board.codes() == (16U | sign_and_zero(quotient, 16)));
    }
  }
}

TEST_CASE("DIVS truncates towards zero, and its remainder has the dividend's sign") {
  SmallBoard board;
  Operands operands(3);
  for (unsigned count = 0; count < k_cases; ++count) {
    const std::uint32_t divisor = operands.next();
    const std::int64_t by = signed_value(divisor, 16);
    if (by == 0) continue;
    const std::uint32_t dividend =
        count % 2 == 0 ? operands.next()
                       : static_cast<std::uint32_t>(signed_value(operands.next(), 16) * by +
                                                    signed_value(operands.next(), 4));
    const std::int64_t exact = signed_value(dividend, 32);
    const std::int64_t quotient = exact / by;
    board.d(1) = divisor;
    board.d(0) = dividend;
    board.set_codes(0x1f);
    REQUIRE(board.execute({0x81c1}).reason == StopReason::cycle_limit);
    if (!fits_signed(quotient, 16)) {
      REQUIRE(board.d(0) == dividend);
      REQUIRE((board.codes() & 0x13U) == 0x12);
    } else {
      REQUIRE(signed_value(board.d(0), 16) == quotient);
      REQUIRE(signed_value(board.d(0) >> 16U, 16) == exact - quotient * by);
      REQUIRE(board.codes() == (16U | sign_and_zero(board.d(0), 16)));
    }
  }
}

TEST_CASE("the largest negative dividend overflows") {
  SmallBoard board;
  board.d(0) = 0x8000'0000;
  board.d(1) = 0xffff;
  CHECK(board.execute({0x81c1}).reason == StopReason::cycle_limit);
  CHECK(board.d(0) == 0x8000'0000);
  CHECK((board.codes() & 2U) != 0);
}

}  // namespace
