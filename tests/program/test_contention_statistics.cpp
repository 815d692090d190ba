#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <vector>

#include "models/bus/bus_levels.hpp"
#include "models/machine/ccett_machine.hpp"
#include "sim/run/contention_statistics.hpp"
#include "tests/catch.hpp"
#include "tests/models/board/source_of_pixels.hpp"
#include "tests/program/program.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;
using maquette::sim::contention_statistics;

// A machine that is busy on its bus, the host's loading included.
struct BusyMachine {
  explicit BusyMachine(int boards, const BusLevel& level = k_transaction_level)
      : parameters(parameters_of(boards, level)),
        source(
            PixelAllotment(parameters.allotment, setup().useful_zone, boards),
            [](PixelPosition /*position*/) { return 0U; },
            [](PixelPosition position) {
              return static_cast<std::uint32_t>(position.column * 13 + position.row * 31) % 60;
            },
            500),
        machine("machine", parameters, source, setup(boards)) {
    machine.observe_bus([this](const BusAccess& access) { log.push_back(access); });
  }

  static MachineParameters parameters_of(int boards, const BusLevel& level) {
    MachineParameters parameters;
    parameters.bus.level = level;
    parameters.boards = places(boards);
    parameters.board = plain_board();
    parameters.frame_memory.width = 64;
    parameters.frame_memory.height = 48;
    return parameters;
  }

  static FrameSetup setup(int boards = 0) {
    FrameSetup setup;
    setup.useful_zone = {3, 5, 50, 40};
    setup.images.assign(static_cast<std::size_t>(boards), std::vector<unsigned char>(200, 1));
    return setup;
  }

  MachineParameters parameters;
  AllottedPixels source;
  CcettMachine machine;
  std::vector<BusAccess> log;
};

TEST_CASE("contention statistics are those of the boards' accesses, recomputed one by one") {
  constexpr int k_boards = 5;
  BusyMachine busy(k_boards);
  sc_core::sc_start();
  const MachineStatistics model = busy.machine.statistics();
  const auto bus = contention_statistics(model);

  std::vector<Duration> waits;
  std::vector<double> sums(k_boards);
  std::vector<double> counts(k_boards);
  Duration sum{};
  BusAccess longest{};
  longest.grant = longest.request - Duration(1);
  for (const BusAccess& access : busy.log) {
    if (access.master >= k_boards) {
      REQUIRE(access.end <= model.load_time);
      continue;
    }
    const Duration wait = access.grant - access.request;
    waits.push_back(wait);
    sum += wait;
    sums[static_cast<std::size_t>(access.master)] += static_cast<double>(wait.count());
    counts[static_cast<std::size_t>(access.master)] += 1;
    if (wait > longest.grant - longest.request) {
      longest = access;
    }
  }
  std::sort(waits.begin(), waits.end());
  REQUIRE(waits.size() == 2 * 50 * 40);
  CHECK(bus.wait_quantiles.half >= waits[1999]);
  CHECK((bus.wait_quantiles.half - waits[1999]) * 16 <= waits[1999]);
  CHECK(bus.wait_quantiles.nine_of_1000 >= waits[3995]);
  CHECK(bus.longest_wait.time == waits.back());
  CHECK(bus.longest_wait.requested_at == longest.request - model.load_time);
  CHECK(bus.longest_wait.master == "board" + std::to_string(longest.master));
  CHECK(bus.longest_wait.behind != bus.longest_wait.master);

  // Little: the mean queue is the sum of all waits over the time.
  CHECK(bus.queue.mean ==
        static_cast<double>(sum.count()) / static_cast<double>(model.frame_time.count()));
  CHECK(bus.queue.longest > 2);
  Duration all{};
  Duration requests{};
  for (const auto& [length, time] : bus.queue.times) {
    all += time;
    requests += time * length;
  }
  CHECK(all == model.frame_time);
  CHECK(requests == sum);

  double means = 0;
  double squares = 0;
  for (std::size_t board = 0; board < k_boards; ++board) {
    means += sums[board] / counts[board];
    squares += std::pow(sums[board] / counts[board], 2);
  }
  CHECK(bus.fairness == Approx(means * means / k_boards / squares).epsilon(1e-12));
  CHECK(bus.fairness < 1);
  CHECK(bus.fairness > 1.0 / k_boards);

  for (std::size_t board = 0; board < k_boards; ++board) {
    const auto& master = bus.masters[board];
    CHECK(std::accumulate(master.waited_for.begin(), master.waited_for.end(), Duration{}) ==
          model.boards[board].wait_grant);
    std::int64_t counted = 0;
    for (const auto& bucket : master.waits) {
      counted += bucket.count;
    }
    CHECK(counted == master.transfers);
  }
}

double sum_of(const maquette::sim::BusShares& shares) {
  double sum = 0;
  maquette::sim::for_each_field<maquette::sim::BusShares>(
      [&](const auto& field) { sum += shares.*field.member; });
  return sum;
}

void check_shares(const BusLevel& level) {
  constexpr int k_boards = 3;
  BusyMachine busy(k_boards, level);
  sc_core::sc_start();
  const MachineStatistics model = busy.machine.statistics();
  const auto bus = contention_statistics(model);

  const VersaBusParameters& parameters = busy.parameters.bus;
  const Period clock = Period::of_frequency(parameters.clock_hz);
  Duration transfer{};
  Duration handover{};
  Duration arbitration{};
  int previous = k_nobody;
  for (const BusAccess& access : busy.log) {
    if (access.master < k_boards) {
      transfer += access.end - access.grant;
      const bool hands_over = previous != access.master;
      handover += hands_over ? clock.times(parameters.handover_clocks) : Duration{};
      arbitration += clock.times(parameters.arbitration_clocks);
    }
    previous = access.master;
  }
  const auto share = [&model](Duration part) {
    return static_cast<double>(part.count()) / static_cast<double>(model.frame_time.count());
  };
  CHECK(bus.buses == 1);
  CHECK(bus.shares.transfer == share(transfer));
  CHECK(bus.shares.arbitration == share(arbitration));
  CHECK(bus.shares.handover == share(handover));
  CHECK(bus.shares.handover > 0);
  CHECK(bus.shares.kept == 0);
  CHECK(bus.shares.idle == share(model.frame_time - transfer - arbitration - handover));
  CHECK(sum_of(bus.shares) == Approx(1).epsilon(1e-12));
  CHECK(bus.occupied == 1 - bus.shares.idle);
}

TEST_CASE("what the bus does with its time sums to one, and is that of its accesses") {
  check_shares(k_transaction_level);
}

TEST_CASE("the same of a bus line by line") { check_shares(k_signal_level); }

TEST_CASE("the same of a bus whose masters run ahead") { check_shares(k_decoupled_level); }

TEST_CASE("on an ideal bus each board has one to itself, so that no share is above one") {
  constexpr int k_boards = 40;
  BusyMachine busy(k_boards, k_ideal_level);
  sc_core::sc_start();
  const auto bus = contention_statistics(busy.machine.statistics(), true);
  CHECK(bus.utilisation > 1);  // accesses overlap
  CHECK(bus.buses == k_boards);
  CHECK(bus.shares.transfer == Approx(bus.utilisation / k_boards).epsilon(1e-12));
  CHECK(bus.shares.arbitration == 0);
  CHECK(sum_of(bus.shares) == Approx(1).epsilon(1e-12));
  CHECK(bus.occupied < 1);
}

TEST_CASE("one board waits for nobody, and its fairness is 1") {
  BusyMachine busy(1);
  sc_core::sc_start();
  const auto bus = contention_statistics(busy.machine.statistics());
  CHECK(bus.fairness == 1);
  CHECK(bus.queue.longest == 1);
  CHECK(bus.longest_wait.behind == "nobody");
  CHECK(bus.wait_quantiles.half == Duration(500'000));  // four clocks of arbitration
  REQUIRE(bus.masters[0].waited_for.size() == 1);
  CHECK(bus.masters[0].waited_for[0] == bus.masters[0].wait);
}

TEST_CASE("an interrupted run has contention statistics of the accesses so far") {
  BusyMachine busy(4);
  sc_core::sc_start(10, sc_core::SC_US);  // within the loading
  CHECK(contention_statistics(busy.machine.statistics()).queue.longest == 0);
  for (int slice = 0; slice < 40; ++slice) {
    sc_core::sc_start(97, sc_core::SC_US);
    const MachineStatistics model = busy.machine.statistics();
    const auto bus = contention_statistics(model);
    Duration all{};
    for (const auto& [length, time] : bus.queue.times) {
      REQUIRE(time > Duration::zero());
      all += time;
    }
    REQUIRE(all >= model.frame_time);
    REQUIRE(bus.longest_wait.time >= bus.wait_max);
    REQUIRE(sum_of(bus.shares) == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("stats.json holds the contention statistics, and compare reads them") {
  using namespace maquette::tests;
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  for (const char* policy : {"priority", "round_robin"}) {
    const Outcome outcome =
        run_maquette("run " + scene + k_small_frame + "--quiet --set bus.arbitration=" + policy +
                     " --outdir " + (scratch / policy).string());
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  }
  const auto bus = nlohmann::json::parse(content_of(scratch / "priority" / "stats.json"))["bus"];
  CHECK(bus["wait_quantiles"]["p50_s"] <= bus["wait_quantiles"]["p999_s"]);
  CHECK(bus["wait_quantiles"]["p999_s"] <= bus["wait_max_s"]);
  CHECK(bus["longest_wait"]["time_s"] == bus["wait_max_s"]);
  CHECK(bus["masters"][3]["waited_for_s"].size() == 4);
  CHECK(bus["masters"][3]["waits"][0]["count"] > 0);
  CHECK(bus["queue"]["times"][0]["length"] == 0);
  const auto same = run_maquette("compare " + (scratch / "priority").string() + " " +
                                 (scratch / "priority").string());
  CHECK(same.exit_code == 0);
  const auto other = run_maquette("compare " + (scratch / "priority").string() + " " +
                                  (scratch / "round_robin").string());
  CHECK(other.exit_code == 1);
}

}  // namespace
