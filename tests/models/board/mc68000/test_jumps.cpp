#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;

struct Target {
  unsigned mode;
  std::initializer_list<unsigned> words;
  std::uint32_t address;
};

/// Control modes, with A2 = 0x2000 and D1 = 0xffff0010.
const Target k_targets[] = {
    {0x12, {}, 0x2000},
    {0x2a, {0xfff0}, 0x1ff0},
    {0x32, {0x1004}, 0x2014},       // D1.W
    {0x32, {0x18fe}, 0xffff'200e},  // D1.L
    {0x32, {0xa002}, 0x4002},       // A2.W
    {0x38, {0x3000}, 0x3000},
    {0x38, {0x9000}, 0xffff'9000},
    {0x39, {0x0001, 0x2344}, 0x0001'2344},
    {0x3a, {0x0010}, 0x1012},
    {0x3b, {0x1002}, 0x1014},
};

void execute(SmallBoard& board, unsigned pattern, const Target& target) {
  board.a(2) = 0x2000;
  board.d(1) = 0xffff'0010;
  board.load({pattern | target.mode});
  board.load(target.words, SmallBoard::k_program + 2);
  REQUIRE(board.processor().step().reason == StopReason::cycle_limit);
}

TEST_CASE("JMP, JSR, LEA and PEA find the same addresses") {
  SmallBoard board;
  board.set_codes(0x1f);
  for (const Target& target : k_targets) {
    const auto after = static_cast<std::uint32_t>(0x1002 + 2 * target.words.size());
    execute(board, 0x4ec0, target);
    CHECK(board.registers().program_counter == target.address);
    board.a(7) = 0x8000;
    execute(board, 0x4e80, target);
    CHECK(board.registers().program_counter == target.address);
    CHECK(board.peek(0x7ffc, 4) == after);
    CHECK(board.a(7) == 0x7ffc);
    execute(board, 0x41c0 | 4U << 9U, target);
    CHECK(board.a(4) == target.address);
    CHECK(board.registers().program_counter == after);
    execute(board, 0x4840, target);
    CHECK(board.peek(0x7ff8, 4) == target.address);
    CHECK(board.a(7) == 0x7ff8);
  }
  CHECK(board.codes() == 0x1f);
}

TEST_CASE("PEA of the stack pushes what it was") {
  SmallBoard board;
  board.execute({0x4857});
  CHECK(board.peek(0x7ffc, 4) == 0x8000);
}

TEST_CASE("RTS and RTR come back, RTR with its condition codes") {
  SmallBoard board;
  board.poke(0x8000, 4, 0x0000'2468);
  board.execute({0x4e75});
  CHECK(board.registers().program_counter == 0x2468);
  CHECK(board.a(7) == 0x8004);
  board.poke(0x8004, 2, 0xa715);
  board.poke(0x8006, 4, 0x0000'1234);
  board.execute({0x4e77});
  CHECK(board.registers().program_counter == 0x1234);
  CHECK(board.a(7) == 0x800a);
  CHECK(board.registers().status() == 0x2715);
}

TEST_CASE("LINK and UNLK make a frame and take it away") {
  SmallBoard board;
  board.a(6) = 0x1111'2222;
  board.execute({0x4e56, 0xfff0});
  CHECK(board.peek(0x7ffc, 4) == 0x1111'2222);
  CHECK(board.a(6) == 0x7ffc);
  CHECK(board.a(7) == 0x7fec);
  board.execute({0x4e5e});
  CHECK(board.a(6) == 0x1111'2222);
  CHECK(board.a(7) == 0x8000);
}

TEST_CASE("LINK and UNLK of the stack pointer itself") {
  SmallBoard board;
  board.execute({0x4e57, 0x0008});
  CHECK(board.peek(0x7ffc, 4) == 0x7ffc);
  CHECK(board.a(7) == 0x8004);
  board.poke(0x8004, 4, 0x5000);
  board.execute({0x4e5f});
  CHECK(board.a(7) == 0x5000);
}

TEST_CASE("an index word of a later processor stops") {
  SmallBoard board;
  for (const unsigned word : {0x1100U, 0x1200U, 0x1400U}) {
    CHECK(board.execute({0x4ef2, word}).reason == StopReason::later_encoding);
  }
}

TEST_CASE("an odd target stops") {
  SmallBoard board;
  board.a(0) = 0x2001;
  CHECK(board.execute({0x4ed0}).reason == StopReason::odd_address);
  board.poke(0x8000, 4, 0x0000'2469);
  CHECK(board.execute({0x4e75}).reason == StopReason::odd_address);
}

TEST_CASE("NOP does nothing") {
  SmallBoard board;
  CHECK(board.execute({0x4e71}).reason == StopReason::cycle_limit);
  CHECK(board.registers().program_counter == 0x1002);
}

}  // namespace
