#include <algorithm>
#include <map>
#include <numeric>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/bus_levels.hpp"
#include "models/bus/versabus.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr Duration k_microsecond{1'000'000};
constexpr Duration k_millisecond = 1000 * k_microsecond;
constexpr Duration k_shortest_access = 5 * k_clock;

VersaBusParameters level(BusLevel what, Duration quantum = Duration::zero()) {
  VersaBusParameters parameters;
  parameters.level = what;
  parameters.quantum = quantum;
  return parameters;
}

std::vector<std::vector<Step>> random_steps(std::mt19937& random) {
  std::vector<std::vector<Step>> masters(static_cast<std::size_t>(2 + below(random, 4)));
  for (std::vector<Step>& steps : masters) {
    steps.resize(static_cast<std::size_t>(1 + below(random, 50)));
    for (Step& step : steps) {
      step.compute = Duration{below(random, 4) == 0 ? 0 : 125'000 * below(random, 80)};
      step.accesses = 1 + below(random, 4);
      step.gap = Duration{125'000 * below(random, 8)};
      step.block = below(random, 2) == 0;
    }
  }
  return masters;
}

std::unique_ptr<Bench> bench(const std::string& name, const VersaBusParameters& parameters,
                             const std::vector<std::vector<Step>>& masters, Style style,
                             const std::function<Duration(Instant)>& access_time) {
  auto result = std::make_unique<Bench>(name, parameters, access_time);
  for (std::size_t i = 0; i < masters.size(); ++i) {
    result->add({static_cast<int>(i % 3), static_cast<int>(i)}, style, script(masters[i]));
  }
  return result;
}

bool same(const BusAccess& a, const BusAccess& b) {
  return a.master == b.master && a.request == b.request && a.decision == b.decision &&
         a.grant == b.grant && a.end == b.end && a.kept == b.kept;
}

bool same_logs(const Bench& a, const Bench& b) {
  return a.log.size() == b.log.size() &&
         std::equal(a.log.begin(), a.log.end(), b.log.begin(), same);
}

Duration uneven(Instant strobe) { return Duration{50'000 + strobe.count() / 1'000 % 700'000}; }

// Of the accesses, each of which lies in a turn: a master that has one goes on until a request
// beyond its quantum, however many others stand.
void check_turns(const std::vector<BusAccess>& log, Duration quantum) {
  std::map<int, std::vector<Instant>> requests;
  for (const BusAccess& access : log) {
    requests[access.master].push_back(access.request);
  }
  std::map<int, std::size_t> taken;
  int runner = k_nobody;
  Instant turn_end{};
  for (const BusAccess& access : log) {
    const bool is_in_turn = access.master == runner && access.request < turn_end;
    if (!is_in_turn) {
      if (runner != k_nobody && taken[runner] < requests[runner].size()) {
        CHECK(requests[runner][taken[runner]] >= turn_end);
      }
      runner = access.master;
      turn_end = (access.decision / quantum + 1) * quantum;
    } else {
      CHECK(access.decision == access.request);
    }
    ++taken[access.master];
  }
}

void check_sums(const Bench& bench) {
  const BusStatistics statistics = bench.bus.statistics();
  for (std::size_t i = 0; i < statistics.masters.size(); ++i) {
    const auto& row = statistics.waited_for[i];
    CHECK(std::accumulate(row.begin(), row.end(), Duration{}) == statistics.masters[i].waited);
  }
}

Instant last_end(const Bench& bench) {
  Instant last{};
  for (const BusAccess& access : bench.log) {
    last = std::max(last, access.end);
  }
  return last;
}

}  // namespace

TEST_CASE("a quantum of at most an access decides nothing otherwise than exact arbitration") {
  std::mt19937 random(1984);
  std::vector<std::array<std::unique_ptr<Bench>, 2>> pairs;
  for (int one = 0; one < 120; ++one) {
    VersaBusParameters exact = level(k_transaction_level);
    exact.arbitration = one % 2 == 0 ? k_priority : k_round_robin;
    exact.arbitration_clocks = below(random, 5);
    VersaBusParameters decoupled = exact;
    decoupled.level = k_decoupled_level;
    const Duration quanta[] = {Duration::zero(), k_tick, Duration{1'000}, k_shortest_access};
    decoupled.quantum = quanta[one % 4];
    const auto masters = random_steps(random);
    const auto style = static_cast<Style>(below(random, 4));
    const std::string name = "pair" + std::to_string(one);
    pairs.push_back({bench(name + "e", exact, masters, style, uneven),
                     bench(name + "d", decoupled, masters, style, uneven)});
  }
  sc_core::sc_start();
  for (const auto& [exact, decoupled] : pairs) {
    REQUIRE_FALSE(exact->log.empty());
    REQUIRE(same_logs(*exact, *decoupled));
    REQUIRE(exact->bus.statistics().waited_for == decoupled->bus.statistics().waited_for);
    REQUIRE(exact->bus.statistics().queue_times == decoupled->bus.statistics().queue_times);
  }
}

TEST_CASE("in a quantum the master whose turn it is sees nobody, however it is simulated") {
  std::mt19937 random(7);
  std::vector<std::vector<std::unique_ptr<Bench>>> cases;
  std::vector<Duration> quanta;
  for (int one = 0; one < 80; ++one) {
    quanta.push_back(k_microsecond * (1 + below(random, 60)));
    const VersaBusParameters parameters = level(k_decoupled_level, quanta.back());
    const auto masters = random_steps(random);
    cases.emplace_back();
    for (const Style style : {Style::promised, Style::annotated, Style::followed_up}) {
      cases.back().push_back(
          bench("turn" + std::to_string(one) + "_" + std::to_string(static_cast<int>(style)),
                parameters, masters, style, uneven));
    }
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < cases.size(); ++one) {
    INFO("case " << one);
    check_turns(cases[one][0]->log, quanta[one]);
    for (const auto& style : cases[one]) {
      REQUIRE(same_logs(*cases[one][0], *style));
      check_sums(*style);
    }
  }
}

TEST_CASE("on an ideal bus everybody is as fast as alone and without arbitration") {
  std::mt19937 random(41);
  struct Case {
    std::unique_ptr<Bench> together;
    std::vector<std::unique_ptr<Bench>> alone;
    std::unique_ptr<Bench> exact;
  };
  std::vector<Case> cases;
  for (int one = 0; one < 60; ++one) {
    const auto masters = random_steps(random);
    const auto style = static_cast<Style>(below(random, 4));
    const auto slave = always(Duration{125'000 * below(random, 12)});
    const std::string name = "ideal" + std::to_string(one);
    VersaBusParameters free = level(k_transaction_level);
    free.arbitration_clocks = free.handover_clocks = 0;
    cases.push_back({bench(name, level(k_ideal_level), masters, style, slave),
                     {},
                     bench(name + "e", level(k_transaction_level), masters, style, slave)});
    for (std::size_t i = 0; i < masters.size(); ++i) {
      cases.back().alone.push_back(
          bench(name + "a" + std::to_string(i), free, {masters[i]}, style, slave));
    }
  }
  sc_core::sc_start();
  for (const Case& one : cases) {
    CHECK(total(one.together->bus.statistics()).waited == Duration::zero());
    CHECK(last_end(*one.together) <= last_end(*one.exact));
    CHECK(one.together->log.size() == one.exact->log.size());
    for (std::size_t i = 0; i < one.alone.size(); ++i) {
      std::vector<Instant> ends;
      for (const BusAccess& access : one.together->log) {
        if (access.master == static_cast<int>(i)) {
          ends.push_back(access.end);
        }
      }
      REQUIRE(ends.size() == one.alone[i]->log.size());
      CHECK(std::equal(ends.begin(), ends.end(), one.alone[i]->log.begin(),
                       [](Instant end, const BusAccess& access) { return end == access.end; }));
    }
  }
}

TEST_CASE("a quantum longer than the time between two requests serialises the masters") {
  std::vector<std::unique_ptr<Bench>> benches;
  const std::vector<std::vector<Step>> masters(
      4, std::vector<Step>(2000, {10 * k_microsecond, 0x1000, 1}));
  for (const Duration quantum : {Duration::zero(), 100 * k_microsecond, k_millisecond}) {
    benches.push_back(bench("serial" + std::to_string(quantum.count()),
                            level(k_decoupled_level, quantum), masters, Style::followed_up,
                            always(Duration{250'000})));
  }
  sc_core::sc_start();
  const auto exact = static_cast<double>(last_end(*benches[0]).count());
  const auto error = [&](const Bench& one) {
    return static_cast<double>(last_end(one).count()) / exact - 1;
  };
  CHECK(error(*benches[1]) > 1.5);
  CHECK(error(*benches[2]) > 1.8);
  CHECK(error(*benches[2]) < 3.01);  // four one after the other
}

TEST_CASE("a machine gives the same picture and whole states at every level of its bus") {
  struct One {
    std::unique_ptr<Run> run;
    Duration frame_time{};
  };
  std::vector<One> runs;
  const std::vector<VersaBusParameters> levels = {
      level(k_transaction_level), level(k_decoupled_level, 20 * k_microsecond),
      level(k_decoupled_level, k_millisecond), level(k_ideal_level)};
  for (const Assignment assignment : {Assignment::fixed, Assignment::on_demand}) {
    for (const VersaBusParameters& bus : levels) {
      MachineParameters parameters = machine(4);
      parameters.bus = bus;
      parameters.allotment = cut_into(Allotment::tiles, 4, 4);
      parameters.allotment.assignment = assignment;
      runs.push_back({std::make_unique<Run>("machine" + std::to_string(runs.size()), parameters,
                                            zone({3, 5, 41, 29}))});
    }
  }
  sc_core::sc_start();
  for (One& one : runs) {
    REQUIRE(one.run->machine.finished());
    one.run->machine.verify_frame();
    const MachineStatistics statistics = one.run->machine.statistics();
    check_states(statistics);
    one.frame_time = statistics.frame_time;
    CHECK(one.run->machine.frame_memory().picture().pixels ==
          runs[0].run->machine.frame_memory().picture().pixels);
  }
  for (const std::size_t first : {std::size_t{0}, levels.size()}) {
    CHECK(runs[first + 3].frame_time < runs[first].frame_time);
    CHECK(runs[first + 2].frame_time > runs[first].frame_time);
    CHECK(total(runs[first + 3].run->machine.statistics().bus).waited == Duration::zero());
  }
}
