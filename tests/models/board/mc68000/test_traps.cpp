#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;

TEST_CASE("what a firmware never does stops with its reason, its address and its word") {
  struct Row {
    unsigned word;
    StopReason reason;
  };
  const Row rows[] = {
      {0x4afc, StopReason::illegal_instruction},
      {0x4848, StopReason::illegal_instruction},
      {0x4c01, StopReason::illegal_instruction},  // MULU.L of the 68020
      {0x49c0, StopReason::illegal_instruction},  // EXTB.L of the 68020
      {0x42c0, StopReason::illegal_instruction},  // MOVE from CCR of the 68010
      {0x0c3a, StopReason::illegal_instruction},  // CMPI with d16(PC) of the 68020
      {0xa123, StopReason::line_a},
      {0xf200, StopReason::line_f},
      {0x4e40, StopReason::trap},
      {0x4e4f, StopReason::trap},
      {0x4e70, StopReason::reset_instruction},
      {0x4e72, StopReason::stop_instruction},
  };
  for (const Row& row : rows) {
    SmallBoard board;
    const Stop stop = board.execute({row.word, 0x2700});
    CHECK(stop.reason == row.reason);
    CHECK(stop.instruction_address == 0x1000);
    CHECK(stop.instruction_word == row.word);
    CHECK(board.registers().program_counter == 0x1000);
    CHECK(board.processor().account().cycles == 0);
  }
}

TEST_CASE("TRAPV stops on overflow only") {
  SmallBoard board;
  board.set_codes(0x1d);
  CHECK(board.execute({0x4e76}).reason == StopReason::cycle_limit);
  board.set_codes(2);
  CHECK(board.execute({0x4e76}).reason == StopReason::overflow_trap);
}

TEST_CASE("CHK stops outside of its bounds only") {
  SmallBoard board;
  const auto check = [&board](unsigned value, unsigned bound) {
    board.d(0) = value;
    board.d(1) = bound;
    return board.execute({0x4181}).reason;
  };
  CHECK(check(0, 0) == StopReason::cycle_limit);
  CHECK(check(0xffff'0005, 5) == StopReason::cycle_limit);
  CHECK(check(6, 5) == StopReason::bounds_check);
  CHECK(check(0xffff, 5) == StopReason::bounds_check);
  CHECK(check(0, 0xffff) == StopReason::bounds_check);
}

TEST_CASE("a division by zero stops") {
  SmallBoard board;
  board.d(0) = 7;
  CHECK(board.execute({0x80c1}).reason == StopReason::divide_by_zero);
  CHECK(board.execute({0x81fc, 0}).reason == StopReason::divide_by_zero);
  CHECK(board.d(0) == 7);
}

TEST_CASE("words and long words at odd addresses stop") {
  SmallBoard board;
  for (const unsigned word : {0x3010U, 0x2010U, 0x3080U, 0x2080U, 0xd150U, 0x4cd0U, 0x4890U}) {
    board.a(0) = 0x4001;
    const Stop stop = board.execute({word, 0x0001});
    CHECK(stop.reason == StopReason::odd_address);
    CHECK(stop.access_address == 0x4001);
  }
  CHECK(board.execute({0x1010}).reason == StopReason::cycle_limit);
}

}  // namespace
