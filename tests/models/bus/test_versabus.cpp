#include "models/bus/arbitration_policies.hpp"
#include "models/bus/versabus.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr Duration k_clock{125'000};
constexpr Duration k_word = 7 * k_clock;  // of board_access to a slave of 250 ns
const VersaBusParameters k_bus;           // 4 clocks of arbitration, 1 of hand-over

std::function<Duration(Instant)> slave_of_250_ns() { return always(Duration{250'000}); }

int transfers(const Bench& bench, int master) {
  return static_cast<int>(
      bench.bus.statistics().masters[static_cast<std::size_t>(master)].transfers);
}

TEST_CASE("one board alone: every access costs arbitration and transfer, never more") {
  Bench bench("alone", k_bus, slave_of_250_ns());
  const Step step{Duration{3'333'333}, 0x100, 2, 6 * k_clock, false};
  constexpr int k_steps = 1000;
  Master& master = bench.add({1, 0}, Style::promised, repeat(step, k_steps));
  sc_core::sc_start();

  const Duration transaction = step.compute + 2 * (4 * k_clock + k_word) + step.gap;
  CHECK(master.outcomes.back().end == k_steps * transaction);
  for (const BusAccess& access : bench.log) {
    REQUIRE(access.grant - access.request == 4 * k_clock);
    REQUIRE(access.end - access.grant == k_word);
  }
  const BusMasterStatistics sum = total(bench.bus.statistics());
  CHECK(sum.transfers == 2 * k_steps);
  CHECK(sum.delayed == 0);
  CHECK(sum.busy == 2 * k_steps * k_word);
  CHECK(sum.arbitration == 2 * k_steps * 4 * k_clock);
  CHECK(sum.longest_wait == 4 * k_clock);
}

TEST_CASE("one board alone that keeps the bus arbitrates once") {
  Bench bench("block", k_bus, slave_of_250_ns());
  Master& master =
      bench.add({1, 0}, Style::promised, script({{Duration{1000}, 0, 10, 6 * k_clock, true}}));
  sc_core::sc_start();
  CHECK(master.outcomes.front().end ==
        Duration{1000} + 4 * k_clock + 10 * k_word + 9 * 6 * k_clock);
  CHECK(bench.bus.statistics().masters[0].held == 9 * 6 * k_clock);
  CHECK(master.outcomes.front().waited == 4 * k_clock);
}

TEST_CASE("a transaction knows its own waits, whatever those before it had to wait") {
  Bench bench("own_waits", k_bus, slave_of_250_ns());
  Master& high = bench.add({2, 0}, Style::promised, script({{Duration::zero(), 0, 50}}));
  Master& low =
      bench.add({1, 0}, Style::promised, script({{Duration::zero(), 0, 2}, {10'000 * k_clock}}));
  sc_core::sc_start();
  REQUIRE(high.outcomes.size() == 1);
  REQUIRE(low.outcomes.size() == 2);
  CHECK(low.outcomes[0].longest_wait > 4 * k_clock);
  CHECK(low.outcomes[1].longest_wait == 4 * k_clock);
  CHECK(low.outcomes[1].waited == 4 * k_clock);
  CHECK(low.outcomes[1].transferred == k_word);
}

TEST_CASE("two boards in lock-step: the lower one waits for the other's access each time") {
  Bench bench("lockstep", k_bus, slave_of_250_ns());
  const Duration compute = 1000 * k_clock;
  constexpr int k_steps = 100;
  Master& high = bench.add({2, 0}, Style::promised, repeat({compute}, k_steps));
  Master& low = bench.add({1, 0}, Style::promised, repeat({compute}, k_steps));
  sc_core::sc_start();
  // Both start together; after the first round the lower one is late by one access with its
  // arbitration and hand-over, and they never meet again.
  const Duration first_high = compute + 4 * k_clock + k_word;
  const Duration first_low = first_high + 5 * k_clock + k_word;
  const Duration round = compute + 5 * k_clock + k_word;
  for (int step = 0; step < k_steps; ++step) {
    REQUIRE(high.outcomes[static_cast<std::size_t>(step)].end == first_high + step * round);
    REQUIRE(low.outcomes[static_cast<std::size_t>(step)].end == first_low + step * round);
  }
  CHECK(bench.bus.statistics().masters[1].delayed == 1);
  CHECK(bench.bus.statistics().waited_for[1][0] == 4 * k_clock + k_word);
}

TEST_CASE("saturation: one transfer per bus cycle, shared in turn") {
  VersaBusParameters parameters;
  parameters.arbitration = k_round_robin;
  Bench bench("saturated", parameters, slave_of_250_ns());
  constexpr int k_masters = 6;
  constexpr int k_steps = 500;
  for (int master = 0; master < k_masters; ++master) {
    bench.add({master % 5, master / 5}, Style::promised, repeat({Duration::zero()}, k_steps));
  }
  sc_core::sc_start();
  const Duration cycle = 5 * k_clock + k_word;
  REQUIRE(bench.log.size() == k_masters * k_steps);
  CHECK(bench.log.back().end == k_masters * k_steps * cycle - k_clock);
  for (std::size_t access = 0; access < bench.log.size(); ++access) {
    REQUIRE(bench.log[access].master == static_cast<int>(access) % k_masters);
  }
  CHECK(total(bench.bus.statistics()).longest_wait == k_masters * cycle - k_word);
}

TEST_CASE("fixed priority starves the lower levels, round robin is fair") {
  VersaBusParameters fair;
  fair.arbitration = k_round_robin;
  Bench starving("starving", k_bus, slave_of_250_ns());
  Bench turning("turning", fair, slave_of_250_ns());
  constexpr int k_steps = 1000;
  for (Bench* bench : {&starving, &turning}) {
    bench->add({0, 0}, Style::promised, repeat({Duration::zero()}, k_steps));
    bench->add({0, 1}, Style::promised, repeat({Duration::zero()}, k_steps));
    bench->add({3, 0}, Style::promised, repeat({Duration::zero()}, k_steps));
  }
  sc_core::sc_start(to_sc_time(k_steps / 2 * (5 * k_clock + k_word)));
  CHECK(transfers(starving, 0) == 0);
  CHECK(transfers(starving, 1) == 0);
  CHECK(transfers(starving, 2) >= k_steps / 2);
  for (int master = 0; master < 3; ++master) {
    CHECK(transfers(turning, master) == Approx(k_steps / 6.0).margin(1));
  }
  sc_core::sc_start();
  // The daisy chain decides within a level: 0 is nearest to the arbiter.
  CHECK(starving.masters[2]->outcomes.back().end < starving.masters[0]->outcomes.front().end);
  CHECK(starving.masters[0]->outcomes.back().end < starving.masters[1]->outcomes.front().end);
}

TEST_CASE("a grant falls on its tick: a request one tick later loses the bus") {
  struct Case {
    Duration late;  // of the high master's request, against the end of the first access
    int second;     // who gets the bus after it
  };
  const Instant first_end = 4 * k_clock + k_word;
  std::vector<std::unique_ptr<Bench>> benches;
  const std::vector<Case> cases{{-k_tick, 2}, {Duration{0}, 2}, {k_tick, 1}};
  for (const Style style :
       {Style::promised, Style::annotated, Style::waiting, Style::followed_up}) {
    for (const Case& one : cases) {
      benches.push_back(std::make_unique<Bench>("tight" + std::to_string(benches.size()), k_bus,
                                                slave_of_250_ns()));
      benches.back()->add({0, 0}, style, script({{Duration{0}}}));
      benches.back()->add({1, 0}, style, script({{Duration{1}}}));
      benches.back()->add({2, 0}, style, script({{first_end + one.late}}));
    }
  }
  sc_core::sc_start();
  for (std::size_t bench = 0; bench < benches.size(); ++bench) {
    const Case& one = cases[bench % cases.size()];
    const auto& log = benches[bench]->log;
    REQUIRE(log.size() == 3);
    CHECK(log[0].grant == 4 * k_clock);
    CHECK(log[0].end == first_end);
    CHECK(log[1].master == one.second);
    CHECK(log[1].grant == first_end + 5 * k_clock);
    CHECK(log[2].grant == log[1].end + 5 * k_clock);
  }
}

TEST_CASE("BCLR: only a strictly higher level ends a block, after the access under way") {
  const Duration gap = 6 * k_clock;
  const Instant first_end = 4 * k_clock + k_word;
  struct Case {
    int level;
    Instant request;
    Instant grant;
  };
  const Instant whole = 4 * k_clock + 5 * k_word + 4 * gap;
  const std::vector<Case> cases{
      {2, first_end - k_word / 2, first_end + 5 * k_clock},         // within an access: at its end
      {2, first_end + gap / 2, first_end + gap / 2 + 5 * k_clock},  // in a gap: at once
      {2, first_end + gap, first_end + gap + 5 * k_clock},  // with the next access: before it
      {2, first_end + gap + k_tick, first_end + gap + k_word + 5 * k_clock},
      {1, first_end, whole + 5 * k_clock},  // the same level waits for the end of the block
      {0, first_end, whole + 5 * k_clock},
  };
  std::vector<std::unique_ptr<Bench>> benches;
  for (const Style style : {Style::promised, Style::waiting, Style::followed_up}) {
    for (const Case& one : cases) {
      benches.push_back(std::make_unique<Bench>("clear" + std::to_string(benches.size()), k_bus,
                                                slave_of_250_ns()));
      benches.back()->add({1, 0}, style, script({{Duration{0}, 0, 5, gap, true}}));
      benches.back()->add({one.level, 1}, style, script({{one.request}}));
    }
  }
  sc_core::sc_start();
  for (std::size_t bench = 0; bench < benches.size(); ++bench) {
    const Case& one = cases[bench % cases.size()];
    INFO("case " << bench);
    CHECK(benches[bench]->masters[1]->outcomes.front().end == one.grant + k_word);
    CHECK(benches[bench]->log.size() == 6);
  }
}

TEST_CASE("who waited for whom: every tick of a wait has a name") {
  Bench bench("whom", k_bus, slave_of_250_ns());
  std::mt19937 generator(7);
  for (int master = 0; master < 5; ++master) {
    std::vector<Step> steps;
    for (int step = 0; step < 400; ++step) {
      steps.push_back({Duration{below(generator, 9'000'000)}, 0, 1 + below(generator, 4),
                       Duration{below(generator, 900'000)}, below(generator, 2) == 1});
    }
    const Style style = std::vector{Style::promised, Style::annotated, Style::waiting,
                                    Style::followed_up}[static_cast<std::size_t>(master % 4)];
    bench.add({master % 3, master}, style, script(steps));
  }
  sc_core::sc_start();
  const BusStatistics& statistics = bench.bus.statistics();
  for (std::size_t master = 0; master < 5; ++master) {
    Duration sum{};
    for (const Duration part : statistics.waited_for[master]) {
      CHECK(part >= Duration::zero());
      sum += part;
    }
    CHECK(sum == statistics.masters[master].waited);
    CHECK(statistics.waited_for[master][master] == statistics.masters[master].arbitration);
  }
}

TEST_CASE("a slave that never answers, and an address without a slave, are bus errors") {
  Bench slow("slow", k_bus, [](Instant strobe) {
    return strobe < Instant{10'000'000} ? Duration{64'000'000} : Duration{64'000'001};
  });
  Master& late = slow.add({0, 0}, Style::promised,
                          script({{Duration{0}}, {Duration{10'000'000}, 0, 3}, {Duration{0}}}));
  Bench unmapped("unmapped", k_bus, slave_of_250_ns());
  Master& lost = unmapped.add({0, 0}, Style::waiting, script({{Duration{0}, (1U << 24U) - 4, 3}}));
  sc_core::sc_start();
  CHECK(late.outcomes[0].status == tlm::TLM_OK_RESPONSE);
  CHECK(late.outcomes[1].status == tlm::TLM_GENERIC_ERROR_RESPONSE);
  CHECK(late.outcomes[1].transferred == Duration{64'000'000});  // one access, not three
  CHECK(slow.bus.statistics().masters[0].errors == 2);
  CHECK(lost.outcomes[0].status == tlm::TLM_ADDRESS_ERROR_RESPONSE);
  CHECK(lost.outcomes[0].transferred == 2 * k_word + k_bus.timeout);
  CHECK(unmapped.bus.statistics().masters[0].errors == 1);
}

TEST_CASE("what makes no bus is refused") {
  VersaBusParameters odd;
  odd.data_width_bits = 8;
  CHECK_THROWS_AS(VersaBus("odd", odd), std::invalid_argument);
  Bench bench("refused", k_bus, slave_of_250_ns());
  bench.add({4, 0}, Style::promised, script({}));
  CHECK_THROWS_WITH(bench.add({5, 0}, Style::promised, script({})),
                    Catch::Matchers::ContainsSubstring("level"));
  CHECK_THROWS_WITH(bench.add({4, 0}, Style::promised, script({})),
                    Catch::Matchers::ContainsSubstring("place"));
  Slave second("second", slave_of_250_ns());
  CHECK_THROWS_WITH(bench.bus.attach_slave(second.socket, {"second", 0xFFFFFF, 2}),
                    Catch::Matchers::ContainsSubstring("overlaps"));
}

TEST_CASE("a broken promise to run ahead stops the run") {
  Bench bench("broken", k_bus, slave_of_250_ns());
  bench.add({0, 0}, Style::promised, [turn = 0](Step& step) mutable {
    if (turn == 1) {
      sc_core::wait(1, sc_core::SC_NS);
    }
    step = {};
    return turn++ < 2;
  });
  CHECK_THROWS_WITH(sc_core::sc_start(), Catch::Matchers::ContainsSubstring("promise"));
}

TEST_CASE("a request in the past stops the run") {
  Bench bench("past", k_bus, slave_of_250_ns());
  bench.add({0, 0}, Style::annotated, script({{Duration{1'000}}, {-k_tick}}));
  CHECK_THROWS_WITH(sc_core::sc_start(), Catch::Matchers::ContainsSubstring("in the past"));
}

TEST_CASE(
    "an access that ends after the longest simulated time stops the run, with its master's name") {
  Bench bench("endless", k_bus, slave_of_250_ns());
  bench.add({0, 0}, Style::annotated, script({{k_longest_run - k_tick}}));
  CHECK_THROWS_WITH(sc_core::sc_start(), Catch::Matchers::ContainsSubstring("master") &&
                                             Catch::Matchers::ContainsSubstring("100 days"));
}

}  // namespace
