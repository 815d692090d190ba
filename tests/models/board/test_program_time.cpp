#include "models/board/program_time.hpp"

#include <limits>

#include "tests/catch.hpp"

namespace maquette::models {
namespace {

using firmware::Operation;
using firmware::Work;
using mc68000::Account;

constexpr Duration k_clock{125'000};

Kvm02Parameters board() {
  Kvm02Parameters parameters;
  parameters.refresh_period = Duration::zero();
  parameters.ram_read_wait_clocks = 2;
  parameters.ram_write_wait_clocks = 1;
  const auto add = static_cast<std::size_t>(Operation::add);
  parameters.arithmetic.operations[add] = {100.5, 10, 3};
  parameters.arithmetic.called[add] = true;
  return parameters;
}

Account account() {
  Account account;
  account.cycles = 1000;
  account.fetches = 100;
  account.reads = 40;
  account.writes = 20;
  return account;
}

Duration elapsed(const Account& account, const Work& work = {}) {
  return ProgramTime(board()).elapsed(account, work);
}

}  // namespace

TEST_CASE("fetches and reads wait as reads, writes as writes") {
  CHECK(elapsed(account()) == k_clock * (1000 + 2 * 140 + 20));
  CHECK(elapsed({}) == Duration::zero());
}

TEST_CASE("an access off the board takes neither its four clocks nor the RAM's wait states") {
  Account off_board = account();
  off_board.cycles += 4 * 6;
  off_board.fetches += 1;
  off_board.bus_fetches = 1;
  off_board.reads += 2;
  off_board.bus_reads = 2;
  off_board.writes += 3;
  off_board.bus_writes = 3;
  CHECK(elapsed(off_board) == elapsed(account()));
  const OperationCost use = ram_use(off_board);
  CHECK(use.clocks == 1000);
  CHECK(use.reads == 140);
  CHECK(use.writes == 20);
}

TEST_CASE("what the host's routines did adds up from call to call, without overhead of calls") {
  Work work{};
  work[Operation::add] = 10;
  const std::int64_t routines = 10 * 1005 / 10 + 10 * (2 * 10 + 3);  // clocks
  ProgramTime time(board());
  CHECK(time.elapsed(account(), work) == k_clock * (1300 + routines));
  CHECK(time.elapsed(account(), work) == k_clock * (1300 + 2 * routines));
  CHECK(time.elapsed(account(), {}) == k_clock * (1300 + 2 * routines));
}

TEST_CASE("refresh takes its share of the program's time") {
  Kvm02Parameters parameters = board();
  parameters.refresh_period = 100 * k_clock;
  parameters.refresh_clocks = 20;
  CHECK(ProgramTime(parameters).elapsed(account(), {}) == k_clock * 1300 * 5 / 4);
}

TEST_CASE("a program that takes longer than any time takes the longest") {
  Account longest;
  longest.cycles = std::numeric_limits<std::int64_t>::max() / 500;
  CHECK(elapsed(longest) == Duration::max());
}

}  // namespace maquette::models
