#include <random>
#include <utility>

#include "sim/trace/board_states.hpp"
#include "tests/catch.hpp"

using maquette::models::Duration;
using maquette::models::Instant;
using namespace maquette::sim;

namespace {

// A board that uses two buses in turn, cut off at `end`, and pauses before it does.
BusRecord random_record(std::mt19937& random, Instant end) {
  BusRecord record;
  record.window.to = end;
  record.boards.resize(2);
  record.buses.resize(2);
  record.pauses.resize(2);
  Instant now{};
  while (now < end) {
    RecordedAccess access;
    access.request = now + Duration(random() % 50);
    access.grant = access.request + Duration(random() % 20);
    access.duration = Duration(1 + random() % 30);
    access.board = 1;
    const Instant pause = now + Duration(random() % ((access.request - now).count() + 1));
    record.pauses[1].push_back(
        {pause, pause + Duration(random() % ((access.request - pause).count() + 1))});
    now = access.end();
    record.buses[random() % 2].accesses.push_back(access);
  }
  return record;
}

BoardState state_at(const BusRecord& record, Instant instant) {
  for (const RecordedBus& bus : record.buses) {
    for (const RecordedAccess& access : bus.accesses) {
      if (access.request <= instant && instant < access.end()) {
        return instant < access.grant ? BoardState::wait_grant : BoardState::transfer;
      }
    }
  }
  for (const RecordedPause& pause : record.pauses[1]) {
    if (pause.from <= instant && instant < pause.to) {
      return BoardState::idle;
    }
  }
  return BoardState::compute;
}

void check_tiling(const BusRecord& record, const std::vector<StateInterval>& intervals) {
  Instant reached = record.window.from;
  for (const StateInterval& interval : intervals) {
    REQUIRE(interval.from == reached);
    REQUIRE(interval.to > interval.from);
    reached = interval.to;
  }
  REQUIRE(reached == record.window.to);
}

}  // namespace

TEST_CASE("a board's states over several buses tile any window, tick by tick as its accesses say") {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    BusRecord record = random_record(random, Instant(2000));
    record.window.from = Instant(random() % 1000);
    record.window.to = record.window.from + Duration(1 + random() % 1000);
    const auto intervals = board_states(record, 1);
    check_tiling(record, intervals);
    for (const StateInterval& interval : intervals) {
      for (Instant instant = interval.from; instant < interval.to; instant += Duration(1)) {
        REQUIRE(interval.state == state_at(record, instant));
      }
    }
  }
}

TEST_CASE("a board that has finished is idle, one without an access computes until then") {
  BusRecord record;
  record.window = {Instant(10), Instant(100)};
  record.boards.resize(1);
  record.boards[0].finish = Instant(40);
  const auto intervals = board_states(record, 0);
  check_tiling(record, intervals);
  REQUIRE(intervals.size() == 2);
  CHECK(intervals[0].state == BoardState::compute);
  CHECK(intervals[0].to == Instant(40));
  CHECK(intervals[1].state == BoardState::idle);
}

TEST_CASE("a board of an interrupted run computes until its request and waits from then on") {
  BusRecord record;
  record.window.to = Instant(100);
  record.boards.resize(2);
  record.buses.resize(1);
  record.buses[0].standing.push_back({1, Instant(70)});
  CHECK(board_states(record, 0).size() == 1);
  const auto intervals = board_states(record, 1);
  check_tiling(record, intervals);
  REQUIRE(intervals.size() == 2);
  CHECK(intervals[1].state == BoardState::wait_grant);
  CHECK(intervals[1].from == Instant(70));
  record.buses[0].standing[0].request = Instant(130);  // not yet made
  CHECK(board_states(record, 1).size() == 1);
}

TEST_CASE("a pause that does not end lasts as long as the window") {
  BusRecord record;
  record.window = {Instant(10), Instant(100)};
  record.boards.resize(1);
  record.pauses = {{{Instant(40), Instant::max()}}};
  const auto intervals = board_states(record, 0);
  check_tiling(record, intervals);
  REQUIRE(intervals.size() == 2);
  CHECK(intervals[0].state == BoardState::compute);
  CHECK(intervals[1].state == BoardState::idle);
  CHECK(intervals[1].from == Instant(40));
}

TEST_CASE("a window without time has no states") {
  BusRecord record;
  record.window = {Instant(7), Instant(7)};
  record.boards.resize(1);
  CHECK(board_states(record, 0).empty());
}
