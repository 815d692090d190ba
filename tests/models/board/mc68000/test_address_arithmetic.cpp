#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

std::uint32_t extended(std::uint32_t value, unsigned bits) {
  return static_cast<std::uint32_t>(signed_value(value, bits));
}

TEST_CASE("ADDA and SUBA work on all 32 bits, extend words and leave the codes") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < 10'000; ++count) {
    const unsigned bits = count % 2 == 0 ? 16 : 32;
    const unsigned size = bits == 16 ? 0x0c0 : 0x1c0;
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    board.set_codes(codes);
    board.a(3) = destination;
    board.d(2) = source;
    board.execute({0xd000U | 3U << 9U | size | 2U});
    REQUIRE(board.a(3) == destination + extended(source, bits));
    board.a(3) = destination;
    board.execute({0x9000U | 3U << 9U | size | 2U});
    REQUIRE(board.a(3) == destination - extended(source, bits));
    REQUIRE(board.codes() == codes);
  }
}

TEST_CASE("CMPA compares all 32 bits with an extended word") {
  SmallBoard board;
  Operands operands(2);
  for (unsigned count = 0; count < 10'000; ++count) {
    const unsigned bits = count % 2 == 0 ? 16 : 32;
    const std::uint32_t destination = operands.next();
    const std::uint32_t source = operands.next();
    const unsigned codes = operands.below(32);
    board.set_codes(codes);
    board.a(3) = destination;
    board.d(2) = source;
    board.execute({0xb000U | 3U << 9U | (bits == 16 ? 0x0c0U : 0x1c0U) | 2U});
    const Expected expected = expected_difference(destination, extended(source, bits), 0, 32);
    REQUIRE(board.codes() == ((codes & 16U) | (expected.codes & 15U)));
    REQUIRE(board.a(3) == destination);
  }
}

TEST_CASE("a register may be added to itself while it moves") {
  SmallBoard board;
  board.a(1) = 0x4000;
  board.poke(0x4000, 4, 0x00010000);
  board.execute({0xd3d9});  // ADDA.L (A1)+,A1
  CHECK(board.a(1) == 0x4004 + 0x00010000);
}

}  // namespace
