#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

/// Executes an instruction with an immediate operand of so many bits.
void execute(SmallBoard& board, unsigned word, std::uint32_t operand, unsigned bits) {
  if (bits == 32) {
    board.execute({word, operand >> 16U, operand & 0xffffU});
  } else {
    board.execute({word, operand & static_cast<std::uint32_t>(mask_of(bits))});
  }
}

Expected expected(unsigned pattern, std::uint32_t destination, std::uint32_t source, unsigned codes,
                  unsigned bits) {
  if (pattern == 0x0600) return expected_sum(destination, source, 0, bits);
  if (pattern == 0x0400) return expected_difference(destination, source, 0, bits);
  if (pattern == 0x0c00) {
    const Expected rest = expected_difference(destination, source, 0, bits);
    return {destination, (codes & 16U) | (rest.codes & 15U)};
  }
  const std::uint32_t result = pattern == 0x0000   ? destination | source
                               : pattern == 0x0200 ? destination & source
                                                   : destination ^ source;
  return {result, (codes & 16U) | sign_and_zero(result, bits)};
}

TEST_CASE("instructions with an immediate operand work on registers and memory") {
  SmallBoard board;
  for (const unsigned pattern : {0x0000U, 0x0200U, 0x0400U, 0x0600U, 0x0a00U, 0x0c00U}) {
    Operands operands(pattern);
    for (unsigned count = 0; count < 6'000; ++count) {
      const unsigned bits = k_sizes[count % 3];
      const std::uint32_t destination = operands.next();
      const std::uint32_t source = operands.next();
      const unsigned codes = operands.below(32);
      const Expected law = expected(pattern, destination, source, codes, bits);
      board.set_codes(codes);
      board.d(4) = destination;
      execute(board, pattern | size_code(bits) | 4U, source, bits);
      REQUIRE(board.d(4) == replaced(destination, law.result, bits));
      REQUIRE(board.codes() == law.codes);
      board.set_codes(codes);
      board.a(4) = 0x4000;
      board.poke(0x4000, bits / 8, destination);
      execute(board, pattern | size_code(bits) | 0x14U, source, bits);
      REQUIRE(board.peek(0x4000, bits / 8) == (law.result & mask_of(bits)));
      REQUIRE(board.codes() == law.codes);
    }
  }
}

TEST_CASE("quick operands are 1 to 8") {
  SmallBoard board;
  Operands operands(3);
  for (unsigned count = 0; count < 6'000; ++count) {
    const unsigned bits = k_sizes[count % 3];
    const unsigned field = count % 8;
    const unsigned quick = field == 0 ? 8 : field;
    const std::uint32_t destination = operands.next();
    board.d(6) = destination;
    board.execute({0x5000U | field << 9U | size_code(bits) | 6U});
    const Expected sum = expected_sum(destination, quick, 0, bits);
    REQUIRE(board.d(6) == replaced(destination, sum.result, bits));
    REQUIRE(board.codes() == sum.codes);
    board.d(6) = destination;
    board.execute({0x5100U | field << 9U | size_code(bits) | 6U});
    const Expected rest = expected_difference(destination, quick, 0, bits);
    REQUIRE(board.d(6) == replaced(destination, rest.result, bits));
    REQUIRE(board.codes() == rest.codes);
  }
}

TEST_CASE("quick operands change whole address registers, and no codes") {
  SmallBoard board;
  board.set_codes(0x1f);
  for (const unsigned size : {0x40U, 0x80U}) {
    board.a(0) = 0xffff'fffe;
    board.execute({0x5008U | 4U << 9U | size});
    CHECK(board.a(0) == 2);
    board.execute({0x5108U | size});
    CHECK(board.a(0) == 0xffff'fffa);
  }
  CHECK(board.codes() == 0x1f);
}

TEST_CASE("MOVEQ extends a byte to 32 bits") {
  SmallBoard board;
  for (unsigned value = 0; value < 256; ++value) {
    board.set_codes(0x1f);
    board.execute({0x7400U | value});
    REQUIRE(board.d(2) == static_cast<std::uint32_t>(signed_value(value, 8)));
    REQUIRE(board.codes() == (16U | sign_and_zero(value, 8)));
  }
}

}  // namespace
