#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

void fill(SmallBoard& board, Operands& operands) {
  for (auto& whole : board.registers().general) whole = operands.next();
}

TEST_CASE("MOVEM stores the registers of its mask upwards, and downwards from the last") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned count = 0; count < 4'000; ++count) {
    const unsigned bytes = count % 2 == 0 ? 2 : 4;
    const unsigned size = bytes == 2 ? 0 : 0x40;
    const unsigned mask = operands.below(0x10000);
    fill(board, operands);
    board.a(3) = 0x4000;
    const auto before = board.registers().general;
    board.execute({0x4880U | size | 0x13U, mask});
    std::uint32_t address = 0x4000;
    for (unsigned number = 0; number < 16; ++number) {
      if ((mask >> number & 1U) == 0) continue;
      REQUIRE(board.peek(address, bytes) == (before[number] & mask_of(8 * bytes)));
      address += bytes;
    }
    REQUIRE(board.registers().general == before);
    board.execute({0x4880U | size | 0x23U, mask});
    address = 0x4000;
    for (unsigned number = 16; number-- != 0;) {
      if ((mask >> (15 - number) & 1U) == 0) continue;
      address -= bytes;
      REQUIRE(board.peek(address, bytes) == (before[number] & mask_of(8 * bytes)));
    }
    REQUIRE(board.a(3) == address);
  }
}

TEST_CASE("MOVEM loads whole registers, words with their sign") {
  SmallBoard board;
  Operands operands(2);
  for (unsigned count = 0; count < 4'000; ++count) {
    const unsigned bytes = count % 2 == 0 ? 2 : 4;
    const bool upwards = count / 2 % 2 == 0;
    const unsigned mask = operands.below(0x10000);
    fill(board, operands);
    board.a(3) = 0x4000;
    for (unsigned word = 0; word < 16; ++word)
      board.poke(0x4000 + bytes * word, bytes, operands.next());
    auto expected = board.registers().general;
    std::uint32_t address = 0x4000;
    for (unsigned number = 0; number < 16; ++number) {
      if ((mask >> number & 1U) == 0) continue;
      expected[number] =
          static_cast<std::uint32_t>(signed_value(board.peek(address, bytes), 8 * bytes));
      address += bytes;
    }
    if (upwards) expected[11] = address;
    board.execute({0x4c80U | (bytes == 2 ? 0U : 0x40U) | (upwards ? 0x1bU : 0x13U), mask});
    REQUIRE(board.registers().general == expected);
  }
}

TEST_CASE("MOVEM has its mask before the words of its address") {
  SmallBoard board;
  board.d(0) = 0x1111;
  board.d(1) = 0x2222;
  board.execute({0x48b9, 0x0003, 0x0000, 0x4100});
  CHECK(board.peek(0x4100, 4) == 0x1111'2222);
  board.execute({0x4cba, 0x000c, 0x30fc});  // MOVEM.W d16(PC),D2-D3, relative to 0x1004
  CHECK(board.d(2) == 0x1111);
  CHECK(board.d(3) == 0x2222);
}

TEST_CASE("MOVEP spreads a register over every second byte and gathers it again") {
  SmallBoard board;
  board.a(1) = 0x4000;
  board.poke(0x4000, 4, 0);
  board.poke(0x4004, 4, 0);
  board.d(0) = 0x1234'5678;
  board.execute({0x01c9, 0x0001});
  CHECK(board.peek(0x4000, 4) == 0x0012'0034);
  CHECK(board.peek(0x4004, 4) == 0x0056'0078);
  board.execute({0x0189, 0x0000});
  CHECK(board.peek(0x4000, 4) == 0x5612'7834);
  board.d(2) = 0xaaaa'bbbb;
  board.execute({0x0509, 0x0000});
  CHECK(board.d(2) == 0xaaaa'5678);
  board.execute({0x0549, 0x0001});
  CHECK(board.d(2) == 0x1234'5678);
}

}  // namespace
