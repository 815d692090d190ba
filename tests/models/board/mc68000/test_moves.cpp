#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

/// Where an operand of 1, 2 or 4 bytes is in memory, and what its address leaves in its register.
struct Place {
  unsigned mode;  // with register 1 where there is one
  std::vector<unsigned> words;
  std::uint32_t before;  // of the register
  std::uint32_t address;
  std::uint32_t after;
};

std::vector<Place> places(std::uint32_t base, unsigned bytes) {
  return {
      {021, {}, base, base, base},
      {031, {}, base, base, base + bytes},
      {041, {}, base, base - bytes, base - bytes},
      {051, {0xfffe}, base, base - 2, base},
      {061, {0x7004}, base, base + 0x24, base},  // D7.W = 0x20
      {070, {base}, 0, base, 0},
      {071, {0xff00, base}, 0, base, 0},  // of whose address 24 bits count
  };
}

unsigned upper(unsigned mode) { return (mode & 7U) << 9U | (mode >> 3U) << 6U; }

unsigned size_of_move(unsigned bits) { return bits == 8 ? 0x1000 : (bits == 16 ? 0x3000 : 0x2000); }

class MoveTest {
 public:
  void run(unsigned bits, unsigned word, const std::vector<unsigned>& words, std::uint32_t value) {
    board.set_codes(0x1f);
    board.d(7) = 0x0001'0020;
    board.load({word});
    std::uint32_t address = SmallBoard::k_program + 2;
    for (const unsigned extension : words) {
      board.load({extension & 0xffffU}, address);
      address += 2;
    }
    REQUIRE(board.processor().step().reason == StopReason::cycle_limit);
    REQUIRE(board.registers().program_counter == address);
    REQUIRE(board.codes() == (16U | sign_and_zero(value, bits)));
  }

  SmallBoard board;
};

TEST_CASE("MOVE takes its operand from every place in memory") {
  MoveTest test;
  Operands operands(1);
  for (unsigned count = 0; count < 300; ++count) {
    const unsigned bits = k_sizes[count % 3];
    for (const Place& place : places(0x4000, bits / 8)) {
      const auto value = static_cast<std::uint32_t>(operands.next() & mask_of(bits));
      test.board.poke(place.address, bits / 8, value);
      test.board.a(1) = place.before;
      test.board.d(2) = 0x5566'7788;
      test.run(bits, size_of_move(bits) | 2U << 9U | place.mode, place.words, value);
      REQUIRE(test.board.d(2) == replaced(0x5566'7788, value, bits));
      REQUIRE(test.board.a(1) == place.after);
    }
  }
}

TEST_CASE("MOVE puts its operand to every place in memory") {
  MoveTest test;
  Operands operands(2);
  for (unsigned count = 0; count < 300; ++count) {
    const unsigned bits = k_sizes[count % 3];
    for (const Place& place : places(0x4000, bits / 8)) {
      const std::uint32_t value = operands.next();
      test.board.poke(place.address - 4, 4, 0x0102'0304);
      test.board.poke(place.address + bits / 8, 4, 0x0506'0708);
      test.board.a(1) = place.before;
      test.board.d(2) = value;
      test.run(bits, size_of_move(bits) | upper(place.mode) | 2U, place.words, value);
      REQUIRE(test.board.peek(place.address, bits / 8) == (value & mask_of(bits)));
      REQUIRE(test.board.peek(place.address - 4, 4) == 0x0102'0304);
      REQUIRE(test.board.peek(place.address + bits / 8, 4) == 0x0506'0708);
      REQUIRE(test.board.a(1) == place.after);
    }
  }
}

TEST_CASE("MOVE from memory to memory has the words of its source first") {
  MoveTest test;
  for (const unsigned bits : k_sizes) {
    for (const Place& from : places(0x4000, bits / 8)) {
      const auto value = static_cast<std::uint32_t>(0x89ab'cdef & mask_of(bits));
      test.board.poke(from.address, bits / 8, value);
      test.board.a(1) = from.before;
      std::vector<unsigned> words = from.words;
      words.insert(words.end(), {0x0000, 0x6000});
      test.run(bits, size_of_move(bits) | upper(071) | from.mode, words, value);
      REQUIRE(test.board.peek(0x6000, bits / 8) == value);
    }
  }
}

TEST_CASE("MOVE of immediate operands, and relative to the program") {
  MoveTest test;
  test.run(8, 0x143c, {0xff80}, 0x80);
  CHECK(test.board.d(2) == 0x80);
  test.run(16, 0x343c, {0x8001}, 0x8001);
  CHECK(test.board.d(2) == 0x8001);
  test.run(32, 0x243c, {0x1234, 0x5678}, 0x1234'5678);
  CHECK(test.board.d(2) == 0x1234'5678);
  test.board.poke(0x1102, 4, 0xcafe'f00d);
  test.run(32, 0x243a, {0x0100}, 0xcafe'f00d);
  CHECK(test.board.d(2) == 0xcafe'f00d);
  test.run(32, 0x243b, {0x70e0}, test.board.peek(0x1002 + 0x20 - 0x20, 4));
}

TEST_CASE("MOVEA extends words and leaves the codes") {
  SmallBoard board;
  board.set_codes(0x0a);
  board.d(1) = 0x0001'8000;
  board.execute({0x3441});
  CHECK(board.a(2) == 0xffff'8000);
  board.execute({0x2441});
  CHECK(board.a(2) == 0x0001'8000);
  CHECK(board.codes() == 0x0a);
}

TEST_CASE("a byte moves the stack pointer by two") {
  SmallBoard board;
  board.d(0) = 0x5a;
  board.execute({0x1f00});  // MOVE.B D0,-(A7)
  CHECK(board.a(7) == 0x7ffe);
  CHECK(board.peek(0x7ffe, 1) == 0x5a);
  board.execute({0x121f});  // MOVE.B (A7)+,D1
  CHECK(board.a(7) == 0x8000);
  CHECK(board.d(1) == 0x5a);
}

TEST_CASE("a register that is moved through itself") {
  SmallBoard board;
  board.a(1) = 0x4000;
  board.execute({0x2309});  // MOVE.L A1,-(A1) stores what it was
  CHECK(board.peek(0x3ffc, 4) == 0x4000);
  board.a(1) = 0x4000;
  board.poke(0x4000, 4, 0x0000'7777);
  board.execute({0x2259});  // MOVEA.L (A1)+,A1 keeps what it loads
  CHECK(board.a(1) == 0x7777);
}

}  // namespace
