#include "models/board/mc68000/native_calls.hpp"

#include <stdexcept>

#include "models/board/mc68000/execution_unit.hpp"
#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;
using maquette::models::mc68000::ExecutionUnit;
using maquette::models::mc68000::NativeCalls;

constexpr std::uint32_t k_routine = 0x3000;

NativeCalls doubling() {
  NativeCalls calls;
  calls.add(k_routine, [](ExecutionUnit& unit) {
    unit.registers.data(0) *= 2;
    unit.counter.charge_at_once({100'000, 10, 2, 1});
    unit.return_from_subroutine();
  });
  return calls;
}

TEST_CASE("the host executes a routine however it is entered, at its cost") {
  const NativeCalls calls = doubling();
  struct Row {
    std::vector<unsigned> words;
    bool pushes;
    unsigned cycles;
  };
  const Row rows[] = {{{0x4eb9, 0x0000, 0x3000}, true, 20},
                      {{0x4eb8, 0x3000}, true, 18},
                      {{0x6100, 0x1ffe}, true, 18},
                      {{0x4ef8, 0x3000}, false, 10},
                      {{0x6000, 0x1ffe}, false, 10}};
  for (const Row& row : rows) {
    SmallBoard board;
    board.processor().use(calls);
    board.d(0) = 21;
    if (!row.pushes) {
      board.a(7) = 0x7ffc;
      board.poke(0x7ffc, 4, 0x2222);
    }
    board.load({});
    std::uint32_t address = 0x1000;
    for (const unsigned word : row.words) {
      board.poke(address, 2, word);
      address += 2;
    }
    REQUIRE(board.processor().step().reason == StopReason::cycle_limit);
    CHECK(board.d(0) == 42);
    CHECK(board.a(7) == 0x8000);
    CHECK(board.registers().program_counter == (row.pushes ? address : 0x2222));
    CHECK(board.processor().account().cycles == 100'000 + row.cycles);
  }
}

TEST_CASE("other calls are the processor's own") {
  const NativeCalls calls = doubling();
  SmallBoard board;
  board.processor().use(calls);
  board.d(0) = 21;
  board.execute({0x4eb8, 0x3002});
  CHECK(board.registers().program_counter == 0x3002);
  board.execute({0x4eb8, 0x7000});
  CHECK(board.d(0) == 21);
}

TEST_CASE("an address can be taken once, and has to be even and within 24 bits") {
  NativeCalls calls = doubling();
  CHECK_THROWS_AS(calls.add(k_routine, {}), std::invalid_argument);
  CHECK_THROWS_AS(calls.add(0x3001, {}), std::invalid_argument);
  CHECK_THROWS_AS(calls.add(0x100'0000, {}), std::invalid_argument);
  CHECK(calls.contains(k_routine));
  CHECK_FALSE(calls.contains(k_routine + 2));
  CHECK_FALSE(calls.contains(0xff'fffe));
}

}  // namespace
