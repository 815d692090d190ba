#include <algorithm>
#include <chrono>
#include <sstream>

#include "sim/report/summary.hpp"
#include "tests/catch.hpp"

using maquette::firmware::Operation;
using maquette::sim::OperationClocks;
using maquette::sim::Statistics;
using maquette::sim::summarise;
using namespace std::chrono_literals;

namespace {

Statistics example() {
  Statistics statistics;
  statistics.frame.width = 768;
  statistics.frame.height = 575;
  statistics.frame.time = 422'480ms;
  statistics.frame.pixels_total = 768 * 575;
  statistics.frame.pixels_synthesised = 200'000;
  for (const char* name : {"kvm02-0", "kvm02-1"}) {
    statistics.boards.push_back({name, 100'000, 316'860ms, 1s, 2s, 102'620ms});
  }
  statistics.rays = {200'000, 50'000, 0, 400'000};
  return statistics;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the summary says what a user asks first") {
  Statistics statistics = example();
  statistics.work[static_cast<int>(Operation::add)] = 10;
  statistics.work[static_cast<int>(Operation::multiply)] = 6;
  statistics.costs.clocks[static_cast<int>(Operation::add)] = 100;
  statistics.costs.clocks[static_cast<int>(Operation::multiply)] = 500;
  const std::string text = summarise(statistics, "a test", "7 min; photograph 4", 2.0);
  CHECK(contains(text, "7 min 02.5 s  (the paper: 7 min; photograph 4)"));
  CHECK(contains(text, "200000 of 441600 pixels"));
  CHECK(contains(text, "times           from a test"));
  CHECK(contains(text, "75.00%"));
  CHECK(contains(text, "25.00%"));
  CHECK(text.find("\nmultiply ") < text.find("\nadd "));
  CHECK(contains(text, "shadow              400000       2.000"));
  CHECK(contains(text, "211 times faster than the machine"));
  CHECK_FALSE(contains(text, "PARTIAL"));
}

TEST_CASE("the summary says how fast the host was, also where it was slower") {
  const Statistics statistics = example();
  CHECK(contains(summarise(statistics, "", "", 100.0), "4.2 times faster than the machine"));
  CHECK(contains(summarise(statistics, "", "", 4224.8), "10 times slower than the machine"));
  CHECK(contains(summarise({}, "", "", 1.0), "no time of the machine passed"));
}

TEST_CASE("the summary says what the bus does with its time, and of how many buses") {
  Statistics statistics = example();
  CHECK(contains(summarise(statistics, "", "", 1.0), "  time            idle 100.000 %\n"));
  statistics.bus.shares = {0.25, 0.125, 0.0625, 0, 0.5625};
  statistics.bus.occupied = 0.4375;
  CHECK(contains(summarise(statistics, "", "", 1.0),
                 "transfer 25.000 %, arbitration 12.500 %, handover 6.250 %, idle 56.250 %\n"));
  CHECK(contains(summarise(statistics, "", "", 1.0), "43.750 % occupied"));
  statistics.bus.buses = 4;
  CHECK(contains(summarise(statistics, "", "", 1.0), "idle 56.250 %, of 4 buses\n"));
}

TEST_CASE("the summary shows how to look at the longest wait") {
  Statistics statistics = example();
  CHECK_FALSE(contains(summarise(statistics, "", "", 1.0), "--trace-window"));
  statistics.bus.longest_wait = {9us, 334'010us, "board1", "board0"};
  CHECK(contains(summarise(statistics, "", "", 1.0),
                 "--trace bus.json --trace-window \"334000 us..334030 us\""));
  statistics.bus.longest_wait = {9us, 1us, "board1", "board0"};
  CHECK(contains(summarise(statistics, "", "", 1.0), "--trace-window \"0 us..21 us\""));
}

TEST_CASE("the summary tells of claims and a shared database only where there are any") {
  Statistics statistics = example();
  const std::string without = summarise(statistics, "a test", "", 1.0);
  CHECK_FALSE(contains(without, "claimed"));
  CHECK_FALSE(contains(without, "database"));
  statistics.boards[1].claims = 1001;
  statistics.boards[1].claim_failed_tries = 17;
  statistics.bus.database_words = 123;
  statistics.frame.imbalance = 0.25;
  const std::string with = summarise(statistics, "a test", "", 1.0);
  CHECK(contains(with, "kvm02-1       claimed 1000 units"));
  CHECK(contains(with, "17 tries found the lock taken"));
  CHECK_FALSE(contains(with, "kvm02-0       claimed"));
  CHECK(contains(with, "123 of them read the shared database"));
  CHECK(contains(with, "25.00 % above the mean"));
}

TEST_CASE("the summary tells of the steps of roots only where there are any") {
  Statistics statistics = example();
  CHECK_FALSE(contains(summarise(statistics, "a test", "", 1.0), "\nroots"));
  statistics.roots.intersections = {1000, 2500, 2.5, 0.375, 0.5, 0.125, {}};
  CHECK(contains(
      summarise(statistics, "a test", "", 1.0),
      "\nroots           1000 of intersections, 2.50 steps each: 1 or 2 for 37.5 %, 3 to 5 "
      "for 50.0 %, more for 12.50 %\n"));
}

TEST_CASE("the lines of the board table are aligned") {
  std::istringstream lines(summarise(example(), "a test", "", 1.0));
  std::vector<std::size_t> lengths;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("board", 0) == 0 || line.rfind("kvm02", 0) == 0) {
      lengths.push_back(line.size());
    }
  }
  REQUIRE(lengths.size() == 3);
  CHECK(std::count(lengths.begin(), lengths.end(), lengths.front()) == 3);
}

TEST_CASE("a partial run says why it ended, and an empty one has no figure that is no number") {
  Statistics statistics = example();
  statistics.partial = true;
  statistics.end_reason = "interrupted";
  const std::string partial = summarise(statistics, "a test", "7 min; photograph 4", 1.0);
  CHECK(contains(partial, "PARTIAL: interrupted"));
  CHECK_FALSE(contains(partial, "the paper"));
  const std::string empty = summarise({}, "a test", "", 0.0);
  CHECK_FALSE(contains(empty, "the paper"));
  CHECK_FALSE(contains(empty, "nan"));
  CHECK_FALSE(contains(empty, "inf"));
}
