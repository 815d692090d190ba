#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

std::uint32_t acted(unsigned action, std::uint32_t value, std::uint32_t bit) {
  switch (action) {
    case 1:
      return value ^ bit;
    case 2:
      return value & ~bit;
    case 3:
      return value | bit;
    default:
      return value;
  }
}

TEST_CASE(
    "bits of registers are numbered modulo 32, those of memory modulo 8, and only Z changes") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < 4 * 256 * 8; ++count) {
    const unsigned action = count % 4;
    const unsigned number = count / 4 % 256;
    const std::uint32_t value = operands.next();
    const unsigned codes = operands.below(32);
    for (const bool immediate : {false, true}) {
      const unsigned pattern = action << 6U | (immediate ? 0x0800U : 0x0100U | 6U << 9U);
      board.d(6) = number;
      board.d(0) = value;
      board.set_codes(codes);
      board.execute({pattern, immediate ? number : 0x4e71U});
      const std::uint32_t bit = 1U << number % 32;
      REQUIRE(board.d(0) == acted(action, value, bit));
      REQUIRE(board.codes() == ((codes & ~4U) | ((value & bit) == 0 ? 4U : 0U)));
      board.a(0) = 0x4001;
      board.poke(0x4001, 1, value);
      board.set_codes(codes);
      board.execute({pattern | 0x10U, immediate ? number : 0x4e71U});
      const std::uint32_t memory_bit = 1U << number % 8;
      REQUIRE(board.peek(0x4001, 1) == (acted(action, value, memory_bit) & 0xffU));
      REQUIRE(board.codes() == ((codes & ~4U) | ((value & memory_bit) == 0 ? 4U : 0U)));
    }
  }
}

TEST_CASE("BTST of an immediate operand takes its byte") {
  SmallBoard board;
  board.d(0) = 9;  // bit 1
  board.execute({0x013c, 0x0002});
  CHECK((board.codes() & 4U) == 0);
  board.execute({0x013c, 0x00fd});
  CHECK((board.codes() & 4U) == 4);
}

}  // namespace
