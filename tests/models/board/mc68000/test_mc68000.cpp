#include "models/board/mc68000/mc68000.hpp"

#include <set>
#include <string>

#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;
using maquette::models::mc68000::name_of;

// MOVEQ #99,D0; loop: ADD.L D0,D1; DBF D0,loop; TRAP #0
void load_loop(SmallBoard& board) { board.load({0x7063, 0xd280, 0x51c8, 0xfffc, 0x4e40}); }

constexpr std::uint64_t k_loop_cycles = 4 + 100 * 8 + 99 * 10 + 14;

TEST_CASE("a loop runs to its end with the cycles of the manual") {
  SmallBoard board;
  load_loop(board);
  const Stop stop = board.processor().run({});
  CHECK(stop.reason == StopReason::trap);
  CHECK(stop.instruction_address == 0x1008);
  CHECK(board.d(1) == 99 * 100 / 2);
  CHECK(board.processor().account().cycles == k_loop_cycles);
  CHECK(board.processor().account().fetches == 1 + 100 + 99 * 2 + 3);
  CHECK(board.processor().account().reads == 0);
}

TEST_CASE("however a run is cut into slices, it ends the same") {
  for (const std::uint64_t slice : {1U, 4U, 5U, 17U, 100U, 1000U}) {
    SmallBoard board;
    load_loop(board);
    Stop stop;
    std::uint64_t limit = 0;
    do {
      limit += slice;
      stop = board.processor().run({limit});
      if (stop.reason != StopReason::cycle_limit) break;
      REQUIRE(board.processor().account().cycles >= limit);
      REQUIRE(board.processor().account().cycles < limit + 14);
    } while (true);
    CHECK(stop.reason == StopReason::trap);
    CHECK(board.d(1) == 99 * 100 / 2);
    CHECK(board.processor().account().cycles == k_loop_cycles);
  }
}

TEST_CASE("no instruction begins at or beyond the limit") {
  SmallBoard board;
  load_loop(board);
  CHECK(board.processor().run({0}).reason == StopReason::cycle_limit);
  CHECK(board.processor().account().cycles == 0);
  board.processor().run({4});
  CHECK(board.processor().account().cycles == 4);
  board.processor().run({5});
  CHECK(board.processor().account().cycles == 12);
}

TEST_CASE("a stop address is not executed") {
  SmallBoard board;
  load_loop(board);
  const Stop stop = board.processor().run({100'000, 0x1008});
  CHECK(stop.reason == StopReason::stop_address);
  CHECK(stop.instruction_address == 0x1008);
  CHECK(board.processor().account().cycles == k_loop_cycles);
  load_loop(board);
  CHECK(board.processor().run({100'000, 0x1000}).reason == StopReason::stop_address);
  CHECK(board.processor().account().cycles == k_loop_cycles);
  CHECK(board.processor().run({k_loop_cycles + 4, 0x1008}).reason == StopReason::cycle_limit);
}

TEST_CASE("long runs are counted beyond what a slice holds") {
  SmallBoard board;
  // MOVEQ #63,D2; outer: MOVE.W #-1,D0; inner: DBF D0,inner; DBF D2,outer; TRAP #0
  board.load({0x743f, 0x303c, 0xffff, 0x51c8, 0xfffe, 0x51ca, 0xfff6, 0x4e40});
  CHECK(board.processor().run({}).reason == StopReason::trap);
  const std::uint64_t inner = 8 + 65'535 * 10 + 14;
  CHECK(board.processor().account().cycles == 4 + 64 * inner + 63 * 10 + 14);
  CHECK(board.processor().account().fetches == 1 + 64 * (2 + 65'535 * 2 + 3) + 63 * 2 + 3);
}

TEST_CASE("what stopped in an error is not charged and can be seen again") {
  SmallBoard board;
  board.load({0x7001, 0x4afc});
  for (unsigned time = 0; time < 2; ++time) {
    const Stop stop = board.processor().run({});
    CHECK(stop.reason == StopReason::illegal_instruction);
    CHECK(stop.instruction_address == 0x1002);
    CHECK(board.processor().account().cycles == 4);
  }
}

TEST_CASE("every reason has a name of its own") {
  std::set<std::string> names;
  for (unsigned reason = 0; reason <= static_cast<unsigned>(StopReason::reset_instruction);
       ++reason) {
    names.insert(name_of(static_cast<StopReason>(reason)));
  }
  CHECK(names.size() == 17);
}

}  // namespace
