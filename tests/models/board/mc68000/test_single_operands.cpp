#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

enum Instruction : unsigned {
  negx = 0x4000,
  clr = 0x4200,
  neg = 0x4400,
  no = 0x4600,
  tst = 0x4a00
};

Expected expected(unsigned pattern, std::uint32_t value, unsigned codes, unsigned bits) {
  const unsigned extend = codes & 16U;
  switch (pattern) {
    case negx: {
      Expected law = expected_difference(0, value, extend >> 4U, bits);
      if ((law.codes & 4U) != 0) law.codes = (law.codes & ~4U) | (codes & 4U);
      return law;
    }
    case clr:
      return {0, extend | 4U};
    case neg:
      return expected_difference(0, value, 0, bits);
    case no:
      return {~value, extend | sign_and_zero(~value, bits)};
    default:
      return {value, extend | sign_and_zero(value, bits)};
  }
}

TEST_CASE("NEG, NEGX, NOT, CLR and TST in registers and in memory") {
  SmallBoard board;
  for (const unsigned pattern : {negx, clr, neg, no, tst}) {
    Operands operands(pattern);
    for (unsigned count = 0; count < 9'000; ++count) {
      const unsigned bits = k_sizes[count % 3];
      const std::uint32_t value = operands.next();
      const unsigned codes = operands.below(32);
      const Expected law = expected(pattern, value, codes, bits);
      board.set_codes(codes);
      board.d(3) = value;
      board.execute({pattern | size_code(bits) | 3U});
      REQUIRE(board.d(3) == replaced(value, law.result, bits));
      REQUIRE(board.codes() == law.codes);
      board.set_codes(codes);
      board.a(3) = 0x4000;
      board.poke(0x4000, bits / 8, value);
      board.execute({pattern | size_code(bits) | 0x1bU});  // (A3)+
      REQUIRE(board.peek(0x4000, bits / 8) == (law.result & mask_of(bits)));
      REQUIRE(board.a(3) == 0x4000 + bits / 8);
      REQUIRE(board.codes() == law.codes);
    }
  }
}

TEST_CASE("TAS tests a byte and sets its highest bit") {
  SmallBoard board;
  for (unsigned value = 0; value < 256; ++value) {
    board.set_codes(0x1f);
    board.d(1) = 0x11223300U | value;
    board.execute({0x4ac1});
    REQUIRE(board.d(1) == (0x11223380U | value));
    REQUIRE(board.codes() == (16U | sign_and_zero(value, 8)));
    board.set_codes(0x1f);
    board.a(1) = 0x4001;
    board.poke(0x4001, 1, value);
    board.execute({0x4ad1});
    REQUIRE(board.peek(0x4001, 1) == (0x80U | value));
    REQUIRE(board.codes() == (16U | sign_and_zero(value, 8)));
  }
}

TEST_CASE("SWAP exchanges halves, EXT carries a sign") {
  SmallBoard board;
  Operands operands(5);
  for (unsigned count = 0; count < 5'000; ++count) {
    const std::uint32_t value = operands.next();
    board.set_codes(0x1f);
    board.d(2) = value;
    board.execute({0x4842});
    REQUIRE(board.d(2) == (value << 16U | value >> 16U));
    REQUIRE(board.codes() == (16U | sign_and_zero(board.d(2), 32)));
    board.d(2) = value;
    board.execute({0x4882});
    REQUIRE(board.d(2) == replaced(value, static_cast<std::uint64_t>(signed_value(value, 8)), 16));
    REQUIRE(board.codes() == (16U | sign_and_zero(value, 8)));
    board.d(2) = value;
    board.execute({0x48c2});
    REQUIRE(board.d(2) == static_cast<std::uint32_t>(signed_value(value, 16)));
    REQUIRE(board.codes() == (16U | sign_and_zero(value, 16)));
  }
}

}  // namespace
