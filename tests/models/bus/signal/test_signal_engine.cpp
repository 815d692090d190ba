#include <algorithm>
#include <sstream>

#include "models/bus/signal_level.hpp"
#include "models/bus/transaction_level.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/signal/random_bus.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

std::string text(const BusAccess& a) {
  std::ostringstream text;
  text << "master " << a.master << ", address " << a.address << (a.write ? " write " : " read ")
       << (a.answered ? a.data : 0) << ", request " << a.request.count() << ", decision "
       << a.decision.count() << ", grant " << a.grant.count() << ", acknowledge "
       << a.slave_time.count() << ", end " << a.end.count() << (a.answered ? "" : ", error")
       << (a.kept ? ", kept" : "") << (a.test_and_set ? ", test and set" : "");
  return text.str();
}

std::string text(const Outcome& a) {
  std::ostringstream text;
  text << a.end.count() << ' ' << a.waited.count() << ' ' << a.transferred.count() << ' '
       << (a.status == tlm::TLM_OK_RESPONSE);
  return text.str();
}

template <class Item>
void check_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(text(a[i]) == text(b[i]));
  }
}

void check_same(const BusStatistics& a, const BusStatistics& b) {
  CHECK(a.waited_for == b.waited_for);
  CHECK(a.queue_times == b.queue_times);
  for (std::size_t i = 0; i < a.masters.size(); ++i) {
    const BusMasterStatistics& one = a.masters[i];
    const BusMasterStatistics& other = b.masters[i];
    CHECK(one.held == other.held);
    CHECK(one.errors == other.errors);
    CHECK(one.delayed == other.delayed);
    CHECK(one.waited == other.waited);
    CHECK(one.busy == other.busy);
    CHECK(one.longest_wait_request == other.longest_wait_request);
    CHECK(one.longest_wait_behind == other.longest_wait_behind);
  }
}

struct Tally {
  std::size_t accesses = 0;
  int errors = 0;
  int kept = 0;
  int test_and_set = 0;
  int contended = 0;
  int ended_by_acknowledge = 0;  // in its very instant, or less than a clock of 512 MHz later
};

void add(Tally& tally, const std::vector<BusAccess>& log) {
  tally.accesses += log.size();
  for (const BusAccess& access : log) {
    tally.errors += access.answered ? 0 : 1;
    tally.kept += access.kept ? 1 : 0;
    tally.test_and_set += access.test_and_set ? 1 : 0;
    tally.contended += access.decision > access.request ? 1 : 0;
    const Duration left = access.end - access.grant - access.slave_time;
    tally.ended_by_acknowledge += access.answered && left < Duration{1'954} ? 1 : 0;
  }
}

}  // namespace

TEST_CASE("every access is at the tick at which transactions have it, with the same data") {
  std::mt19937 random(1981);
  std::vector<std::array<std::unique_ptr<RandomBench>, 2>> pairs;
  for (int one = 0; one < 400; ++one) {
    const RandomBus bus = random_bus(random);
    const std::string name = "bus" + std::to_string(one);
    pairs.push_back({std::make_unique<RandomBench>(name + "t", bus, k_transaction_level),
                     std::make_unique<RandomBench>(name + "s", bus, k_signal_level)});
  }
  sc_core::sc_start();
  Tally tally;
  for (const auto& [transaction, signal] : pairs) {
    INFO(signal->bus.name());
    check_same(transaction->log, signal->log);
    check_same(transaction->bus.statistics(), signal->bus.statistics());
    for (std::size_t i = 0; i < transaction->masters.size(); ++i) {
      check_same(transaction->masters[i]->outcomes, signal->masters[i]->outcomes);
    }
    for (std::size_t i = 0; i < transaction->slaves.size(); ++i) {
      CHECK(transaction->slaves[i]->cells == signal->slaves[i]->cells);
    }
    add(tally, signal->log);
  }
  CHECK(tally.accesses > 70'000);
  CHECK(tally.contended > 30'000);
  CHECK(tally.kept > 20'000);
  CHECK(tally.test_and_set > 10'000);
  CHECK(tally.errors > 5'000);
  CHECK(tally.ended_by_acknowledge > 1'000);
}
