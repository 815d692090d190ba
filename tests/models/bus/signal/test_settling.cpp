#include "models/bus/signal/settling.hpp"

#include "models/bus/signal_level.hpp"
#include "models/bus/transaction_level.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr Duration k_clock{125'000};

VersaBusParameters at_level(const BusLevel& level) {
  VersaBusParameters parameters;
  parameters.level = level;
  return parameters;
}

// A master that posts so many delta cycles late in its instant.
Master::Next after_cycles(int cycles) {
  return [cycles, done = false](Step& step) mutable {
    for (int cycle = 0; !done && cycle < cycles; ++cycle) {
      sc_core::wait(sc_core::SC_ZERO_TIME);
    }
    step = {};
    return !std::exchange(done, true);
  };
}

std::unique_ptr<Bench> late(const std::string& name, const BusLevel& level, int cycles) {
  auto bench = std::make_unique<Bench>(name, at_level(level), always(2 * k_clock));
  bench->add({0, 0}, Style::annotated, script({{Duration::zero()}}));
  bench->add({3, 0}, Style::annotated, after_cycles(cycles));
  return bench;
}

}  // namespace

TEST_CASE("a request counts in its instant, in whichever delta cycle it comes") {
  std::vector<std::unique_ptr<Bench>> benches;
  for (int cycles = 0; cycles < Settling::k_delta_cycles - 4; ++cycles) {
    benches.push_back(late("late" + std::to_string(cycles), k_signal_level, cycles));
  }
  benches.push_back(late("exact", k_transaction_level, 100));
  sc_core::sc_start();
  for (const auto& bench : benches) {
    REQUIRE(bench->log.size() == 2);
    CHECK(bench->log[0].master == 1);
    CHECK(bench->log[0].decision == Instant{0});
  }
}

TEST_CASE("a request after its instant has settled is misuse, not another result") {
  const auto bench = late("too_late", k_signal_level, 2 * Settling::k_delta_cycles);
  CHECK_THROWS_WITH(sc_core::sc_start(), Catch::Matchers::ContainsSubstring("late in its instant"));
}
