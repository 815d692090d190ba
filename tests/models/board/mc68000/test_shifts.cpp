#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

enum Kind : unsigned { arithmetic, logical, rotate_extended, rotate };

// One step at a time, as the manual draws it.
Expected shifted(unsigned kind, bool left, std::uint32_t value, unsigned count, unsigned codes,
                 unsigned bits) {
  const std::uint32_t top = 1U << (bits - 1);
  auto result = static_cast<std::uint32_t>(value & mask_of(bits));
  bool extend = (codes & 16U) != 0;
  bool carry = kind == rotate_extended && extend;
  bool overflow = false;
  for (unsigned step = 0; step < count; ++step) {
    const bool out = (result & (left ? top : 1U)) != 0;
    const bool sign = (result & top) != 0;
    const bool in = kind == rotate                ? out
                    : kind == rotate_extended     ? extend
                    : kind == arithmetic && !left ? sign
                                                  : false;
    result = left ? result << 1U | (in ? 1U : 0U) : result >> 1U | (in ? top : 0U);
    result &= static_cast<std::uint32_t>(mask_of(bits));
    carry = out;
    if (kind != rotate) extend = out;
    if (kind == arithmetic && ((result & top) != 0) != sign) overflow = true;
  }
  return {result, (extend ? 16U : 0U) | sign_and_zero(result, bits) | (overflow ? 2U : 0U) |
                      (carry ? 1U : 0U)};
}

unsigned code(unsigned kind, bool left, unsigned bits) {
  return 0xe000U | (left ? 0x100U : 0U) | size_code(bits) | kind << 3U;
}

TEST_CASE("every shift by every count in a register") {
  SmallBoard board;
  Operands operands(1);
  for (unsigned variant = 0; variant < 24; ++variant) {
    const unsigned kind = variant % 4;
    const bool left = variant / 4 % 2 != 0;
    const unsigned bits = k_sizes[variant / 8];
    for (unsigned sample = 0; sample < 40 * 64; ++sample) {
      const unsigned count = sample % 64;
      const std::uint32_t value = operands.next();
      const unsigned codes = operands.below(32);
      board.set_codes(codes);
      board.d(0) = value;
      board.d(1) = count | (operands.next() & ~63U);
      const std::uint64_t begin = board.processor().account().cycles;
      board.execute({code(kind, left, bits) | 1U << 9U | 0x20U});
      const Expected expected = shifted(kind, left, value, count, codes, bits);
      REQUIRE(board.d(0) == replaced(value, expected.result, bits));
      REQUIRE(board.codes() == expected.codes);
      REQUIRE(board.processor().account().cycles - begin == (bits == 32 ? 8 : 6) + 2 * count);
    }
  }
}

TEST_CASE("shifts by a count in the instruction, which is 1 to 8") {
  SmallBoard board;
  Operands operands(2);
  for (unsigned variant = 0; variant < 24 * 8; ++variant) {
    const unsigned kind = variant % 4;
    const bool left = variant / 4 % 2 != 0;
    const unsigned bits = k_sizes[variant / 8 % 3];
    const unsigned field = variant / 24;
    const unsigned count = field == 0 ? 8 : field;
    for (unsigned sample = 0; sample < 100; ++sample) {
      const std::uint32_t value = operands.next();
      const unsigned codes = operands.below(32);
      board.set_codes(codes);
      board.d(7) = value;
      const std::uint64_t begin = board.processor().account().cycles;
      board.execute({code(kind, left, bits) | field << 9U | 7U});
      const Expected expected = shifted(kind, left, value, count, codes, bits);
      REQUIRE(board.d(7) == replaced(value, expected.result, bits));
      REQUIRE(board.codes() == expected.codes);
      REQUIRE(board.processor().account().cycles - begin == (bits == 32 ? 8 : 6) + 2 * count);
    }
  }
}

TEST_CASE("words in memory are shifted by one") {
  SmallBoard board;
  for (unsigned variant = 0; variant < 8; ++variant) {
    const unsigned kind = variant % 4;
    const bool left = variant / 4 != 0;
    for (unsigned value = 0; value < 0x10000; value += 7) {
      const unsigned codes = value % 32;
      board.set_codes(codes);
      board.poke(0x4000, 2, value);
      board.a(6) = 0x4000;
      board.execute({0xe0c0U | kind << 9U | (left ? 0x100U : 0U) | 0x16U});
      const Expected expected = shifted(kind, left, value, 1, codes, 16);
      REQUIRE(board.peek(0x4000, 2) == expected.result);
      REQUIRE(board.codes() == expected.codes);
    }
  }
}

}  // namespace
