#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;

TEST_CASE("the condition codes go to the status register and back") {
  SmallBoard board;
  for (unsigned codes = 0; codes < 32; ++codes) {
    board.d(0) = 0xffff'ffe0U | codes;
    board.execute({0x44c0});
    REQUIRE(board.codes() == codes);
    board.d(1) = 0xaaaa'5555;
    board.execute({0x40c1});
    REQUIRE(board.d(1) == (0xaaaa'2700U | codes));
    for (unsigned operand = 0; operand < 32; ++operand) {
      board.set_codes(codes);
      board.execute({0x003c, operand});
      REQUIRE(board.codes() == (codes | operand));
      board.set_codes(codes);
      board.execute({0x023c, operand});
      REQUIRE(board.codes() == (codes & operand));
      board.set_codes(codes);
      board.execute({0x0a3c, operand});
      REQUIRE(board.codes() == (codes ^ operand));
    }
  }
}

TEST_CASE("the modes have stacks of their own") {
  SmallBoard board;
  board.a(0) = 0x6000;
  board.execute({0x4e60});  // MOVE A0,USP
  board.execute({0x4e69});  // MOVE USP,A1
  CHECK(board.a(1) == 0x6000);
  board.execute({0x46fc, 0x0304});
  CHECK(board.registers().status() == 0x0304);
  CHECK(board.a(7) == 0x6000);
  CHECK(board.registers().other_stack == 0x8000);
}

TEST_CASE("operations on the status register, and RTE") {
  SmallBoard board;
  board.execute({0x027c, 0xf8ff});
  CHECK(board.registers().status() == 0x2000);
  board.execute({0x007c, 0x0315});
  CHECK(board.registers().status() == 0x2315);
  board.execute({0x0a7c, 0x0101});
  CHECK(board.registers().status() == 0x2214);
  board.poke(0x8000, 2, 0x0419);
  board.poke(0x8002, 4, 0x0000'3000);
  board.execute({0x4e73});
  CHECK(board.registers().program_counter == 0x3000);
  CHECK(board.registers().status() == 0x0419);
  CHECK(board.registers().other_stack == 0x8006);
}

TEST_CASE("what is privileged stops in user mode, before it does anything") {
  const std::vector<std::vector<unsigned>> privileged = {
      {0x46fc, 0x2000}, {0x007c, 0x2000}, {0x027c, 0x0000}, {0x0a7c, 0x2000}, {0x4e60},
      {0x4e68},         {0x4e70},         {0x4e72, 0x2000}, {0x4e73}};
  for (const auto& words : privileged) {
    SmallBoard board;
    board.registers().set_status(0);
    const auto before = board.registers().general;
    board.load({words[0], words.back()});
    const Stop stop = board.processor().step();
    CHECK(stop.reason == StopReason::privilege_violation);
    CHECK(stop.instruction_word == words[0]);
    CHECK(board.registers().general == before);
    CHECK(board.registers().status() == 0);
  }
}

TEST_CASE("the trace bit stops") {
  SmallBoard board;
  CHECK(board.execute({0x46fc, 0xa700}).reason == StopReason::trace);
  CHECK(board.execute({0x007c, 0x8000}).reason == StopReason::trace);
}

}  // namespace
