#include "models/bus/bus_statistics.hpp"

#include <random>
#include <stdexcept>

#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

Duration random_time(std::mt19937& generator) { return Duration{below(generator, 1'000'000)}; }

// Of `masters` masters, the last of which is the host; each row of waits sums to what it waited.
BusStatistics random_backplane(std::mt19937& generator, std::size_t masters) {
  BusStatistics bus;
  bus.masters.resize(masters);
  bus.queue_times.resize(masters);
  bus.waited_for.assign(masters, std::vector<Duration>(masters));
  for (std::size_t a = 0; a < masters; ++a) {
    BusMasterStatistics& master = bus.masters[a];
    master.transfers = below(generator, 1000);
    master.busy = random_time(generator);
    master.longest_wait = random_time(generator);
    master.longest_wait_behind = below(generator, static_cast<int>(masters));
    bus.queue_times[a] = random_time(generator);
    for (Duration& time : bus.waited_for[a]) {
      time = random_time(generator);
      master.waited += time;
    }
  }
  return bus;
}

TEST_CASE("backplanes combined keep every board's figures, and sum up the host's") {
  std::mt19937 generator(29);
  for (int one = 0; one < 300; ++one) {
    const auto ports = static_cast<std::size_t>(1 + below(generator, 4));
    const std::size_t boards = ports + static_cast<std::size_t>(below(generator, 9));
    std::vector<BusStatistics> backplanes;
    for (std::size_t port = 0; port < ports; ++port) {
      backplanes.push_back(random_backplane(generator, (boards - port + ports - 1) / ports + 1));
    }
    const BusStatistics all = combined(backplanes, boards);
    REQUIRE(all.masters.size() == boards + 1);
    std::int64_t host_transfers = 0;
    for (const BusStatistics& backplane : backplanes) {
      host_transfers += backplane.masters.back().transfers;
    }
    CHECK(all.masters.back().transfers == host_transfers);
    for (std::size_t board = 0; board < boards; ++board) {
      const BusStatistics& backplane = backplanes[board % ports];
      const BusMasterStatistics& alone = backplane.masters[board / ports];
      const BusMasterStatistics& master = all.masters[board];
      CHECK(master.transfers == alone.transfers);
      CHECK(master.longest_wait == alone.longest_wait);
      const auto behind = static_cast<std::size_t>(master.longest_wait_behind);
      CHECK((behind == boards ||
             (behind % ports == board % ports &&
              behind / ports == static_cast<std::size_t>(alone.longest_wait_behind))));
      Duration waited{};
      for (std::size_t other = 0; other <= boards; ++other) {
        waited += all.waited_for[board][other];
        const bool may_meet = other == boards || other % ports == board % ports;
        CHECK((may_meet || all.waited_for[board][other] == Duration::zero()));
      }
      CHECK(waited == master.waited);
    }
  }
}

TEST_CASE("what backplanes have together and no duration holds is refused") {
  std::mt19937 generator(31);
  std::vector<BusStatistics> backplanes{random_backplane(generator, 2),
                                        random_backplane(generator, 2)};
  for (BusStatistics& backplane : backplanes) {
    backplane.queue_times[0] = k_longest_run;
  }
  CHECK_THROWS_AS(combined(backplanes, 2), std::overflow_error);
  backplanes[0].masters[0].busy = backplanes[0].masters[1].busy = k_longest_run;
  CHECK_THROWS_AS(total(backplanes[0]), std::overflow_error);
}

TEST_CASE("the longest wait is that of the earliest master that had it") {
  BusStatistics bus;
  CHECK(longest_waiting_master(bus) == k_nobody);
  bus.masters.resize(4);
  bus.masters[1].longest_wait = bus.masters[3].longest_wait = Duration{5};
  bus.masters[1].longest_wait_request = Instant{9};
  bus.masters[3].longest_wait_request = Instant{1};
  CHECK(longest_waiting_master(bus) == 1);
  CHECK(total(bus).longest_wait_request == Instant{9});
}

}  // namespace
