#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

VersaBusParameters random_bus(std::mt19937& random) {
  VersaBusParameters parameters;
  parameters.arbitration = below(random, 2) == 0 ? k_priority : k_round_robin;
  parameters.arbitration_clocks = below(random, 5);
  parameters.handover_clocks = below(random, 3);
  return parameters;
}

std::vector<Step> random_steps(std::mt19937& random) {
  std::vector<Step> steps(static_cast<std::size_t>(20 + below(random, 40)));
  for (Step& step : steps) {
    step.compute = Duration{below(random, 3) == 0 ? 0 : 125'000 * below(random, 60)};
    step.accesses = 1 + below(random, 4);
    step.gap = Duration{125'000 * below(random, 8)};
    step.block = below(random, 2) == 0;
  }
  return steps;
}

// How long exactly 1, 2, ... requests stood, by sorting the ends of all waits.
std::vector<Duration> queue_times(const std::vector<BusAccess>& log, std::size_t masters) {
  std::vector<std::pair<Instant, int>> changes;
  for (const BusAccess& access : log) {
    changes.emplace_back(access.request, 1);
    changes.emplace_back(access.grant, -1);
  }
  std::sort(changes.begin(), changes.end());
  std::vector<Duration> times(masters);
  Instant since{};
  int length = 0;
  for (const auto& [instant, change] : changes) {
    if (length > 0) {
      times[static_cast<std::size_t>(length - 1)] += instant - since;
    }
    since = instant;
    length += change;
  }
  return times;
}

// For each access, the time that its wait shares with the other masters' accesses.
struct Overlap {
  std::vector<std::vector<Duration>> waited_for;
  std::vector<int> longest_behind;
};

Overlap transfers_during_waits(const std::vector<BusAccess>& log, std::size_t masters) {
  Overlap result{std::vector<std::vector<Duration>>(masters, std::vector<Duration>(masters)),
                 std::vector<int>(masters, k_nobody)};
  std::vector<Duration> longest(masters);
  for (const BusAccess& waiting : log) {
    std::vector<Duration> row(masters);
    for (const BusAccess& other : log) {
      const Instant from = std::max(waiting.request, other.grant);
      const Instant to = std::min(waiting.grant, other.end);
      if (other.master != waiting.master && from < to) {
        row[static_cast<std::size_t>(other.master)] += to - from;
      }
    }
    const auto master = static_cast<std::size_t>(waiting.master);
    for (std::size_t other = 0; other < masters; ++other) {
      result.waited_for[master][other] += row[other];
    }
    const auto most = std::max_element(row.begin(), row.end());
    if (waiting.grant - waiting.request > longest[master]) {
      longest[master] = waiting.grant - waiting.request;
      result.longest_behind[master] =
          *most > Duration::zero() ? static_cast<int>(most - row.begin()) : k_nobody;
    }
  }
  return result;
}

void check_rows(const BusStatistics& statistics) {
  for (std::size_t master = 0; master < statistics.masters.size(); ++master) {
    Duration row{};
    for (const Duration part : statistics.waited_for[master]) {
      REQUIRE(part >= Duration::zero());
      row += part;
    }
    REQUIRE(row == statistics.masters[master].waited);
  }
}

TEST_CASE("the account of a bus is what the log of its accesses says") {
  std::mt19937 random(84);
  std::vector<std::unique_ptr<Bench>> benches;
  for (int one = 0; one < 60; ++one) {
    benches.push_back(std::make_unique<Bench>("bench" + std::to_string(one), random_bus(random),
                                              always(Duration{10'000 * below(random, 40)})));
    const int masters = 1 + below(random, 6);
    for (int master = 0; master < masters; ++master) {
      benches.back()->add({below(random, 5), master}, static_cast<Style>(below(random, 3)),
                          script(random_steps(random)));
    }
  }
  sc_core::sc_start();
  int waits_of_several = 0;
  for (const auto& bench : benches) {
    const BusStatistics statistics = bench->bus.statistics();
    const std::size_t masters = statistics.masters.size();
    check_rows(statistics);
    REQUIRE(statistics.queue_times == queue_times(bench->log, masters));
    for (std::size_t master = 0; master < masters; ++master) {
      const BusMasterStatistics& account = statistics.masters[master];
      WaitHistogram waits;
      for (const BusAccess& access : bench->log) {
        if (access.master == static_cast<int>(master)) {
          waits.add(access.grant - access.request);
        }
      }
      REQUIRE(account.waits.count() == account.transfers);
      REQUIRE(account.waits.quantile(500) == waits.quantile(500));
      REQUIRE(account.waits.quantile(1000) == account.longest_wait);
    }
    waits_of_several += masters > 2 && statistics.queue_times[2] > Duration::zero() ? 1 : 0;
  }
  REQUIRE(waits_of_several > 10);
}

// Of every wait behind others, the part that is neither their transfer nor a gap in which they kept
// the bus is an arbitration: with arbitration in no time and no kept bus, transfers are all.
TEST_CASE("a master waits for another while that one transfers") {
  std::mt19937 random(85);
  std::vector<std::unique_ptr<Bench>> benches;
  for (int one = 0; one < 40; ++one) {
    VersaBusParameters parameters = random_bus(random);
    parameters.arbitration_clocks = parameters.handover_clocks = 0;
    benches.push_back(std::make_unique<Bench>("bench" + std::to_string(one), parameters,
                                              always(Duration{10'000 * below(random, 40)})));
    const int masters = 2 + below(random, 5);
    for (int master = 0; master < masters; ++master) {
      std::vector<Step> steps = random_steps(random);
      for (Step& step : steps) {
        step.block = false;
      }
      benches.back()->add({below(random, 5), master}, static_cast<Style>(below(random, 3)),
                          script(std::move(steps)));
    }
  }
  sc_core::sc_start();
  for (const auto& bench : benches) {
    const BusStatistics statistics = bench->bus.statistics();
    const Overlap expected = transfers_during_waits(bench->log, statistics.masters.size());
    check_rows(statistics);
    REQUIRE(statistics.waited_for == expected.waited_for);
    for (std::size_t master = 0; master < statistics.masters.size(); ++master) {
      REQUIRE(statistics.masters[master].longest_wait_behind == expected.longest_behind[master]);
    }
  }
}

}  // namespace
