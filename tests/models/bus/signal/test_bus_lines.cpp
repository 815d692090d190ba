#include "models/bus/signal/bus_lines.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "models/bus/signal_level.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/signal/random_bus.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

RandomBus busy_bus() {
  std::mt19937 random(29);
  RandomBus bus = random_bus(random);
  bus.parameters.data_width_bits = 32;
  bus.parameters.arbitration = k_priority;
  bus.parameters.arbitration_clocks = 3;
  bus.parameters.timeout = Duration{2'000'000};
  bus.slaves = {{0, 1, {}}, {k_slave_distance, 0, Duration{250'000}}};
  bus.masters.clear();
  for (int master = 0; master < 5; ++master) {
    bus.masters.push_back(random_master(random, master, 4, 2));
    bus.masters.back().access.clock = Period::of_frequency(8e6);
  }
  return bus;
}

// All that lines have shown, delta by delta.
class LineLog {
 public:
  void note(const LineState& line) {
    changes_[line.name].emplace_back(kernel_now(), line.value);
    bits_[line.name] = line.bits;
  }

  // At the end of an instant.
  [[nodiscard]] std::uint64_t value(const std::string& line, Instant instant) const {
    const auto& changes = changes_.at(line);
    const auto after =
        std::upper_bound(changes.begin(), changes.end(), instant,
                         [](Instant when, const auto& change) { return when < change.first; });
    return std::prev(after)->second;
  }

  [[nodiscard]] bool is_low(const std::string& line, Instant instant) const {
    return value(line, instant) == 0;
  }

  // Within an instant, for however short.
  [[nodiscard]] bool falls(const std::string& line, Instant instant) const {
    const auto& changes = changes_.at(line);
    return std::find(changes.begin(), changes.end(), std::pair{instant, std::uint64_t{0}}) !=
           changes.end();
  }

  [[nodiscard]] Duration low(const std::string& line) const {
    const auto& changes = changes_.at(line);
    Duration time{};
    for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
      time += changes[i].second == 0 ? changes[i + 1].first - changes[i].first : Duration::zero();
    }
    return time;
  }

  [[nodiscard]] int bits(const std::string& line) const { return bits_.at(line); }
  [[nodiscard]] std::size_t count() const { return changes_.size(); }

 private:
  std::map<std::string, std::vector<std::pair<Instant, std::uint64_t>>> changes_;
  std::map<std::string, int> bits_;
};

void check_low(const LineLog& lines, const std::string& line, Instant from, Instant to) {
  INFO(line);
  CHECK(lines.is_low(line, from));
  CHECK(lines.is_low(line, to - k_tick));
}

void check_arbitration(const LineLog& lines, const BusAccess& access, int level) {
  if (access.decision < access.grant) {
    check_low(lines, "BR" + std::to_string(level) + "_n", access.request, access.grant);
    check_low(lines, "BG" + std::to_string(level) + "_n", access.decision, access.grant);
  }
  CHECK_FALSE(lines.is_low("BG" + std::to_string(level) + "_n", access.grant));
  check_low(lines, "BBSY_n", access.grant, access.end);
}

// The slave's answer stands until the strobes rise; that of the timer ends the access at once.
void check_answer(const LineLog& lines, const BusAccess& access) {
  const Instant answer = access.grant + access.slave_time;
  CHECK(lines.falls("DTACK_n", answer) == access.answered);
  CHECK(lines.falls("BERR_n", answer) == !access.answered);
  if (access.slave_time > Duration::zero()) {
    CHECK_FALSE(lines.is_low("DTACK_n", answer - k_tick));
  }
  if (access.answered) {
    check_low(lines, "DTACK_n", answer, access.end);
  } else {
    CHECK(answer == access.end);
    CHECK_FALSE(lines.is_low("DTACK_n", answer));
  }
}

void check_transfer(const LineLog& lines, const BusAccess& access) {
  check_low(lines, "AS_n", access.grant, access.end);
  check_low(lines, "DS0_n", access.grant, access.grant + access.slave_time);
  check_low(lines, "DS1_n", access.grant, access.grant + access.slave_time);
  CHECK(lines.is_low("WRITE_n", access.grant) == access.write);
  CHECK(lines.value("address", access.grant) == access.address);
  if (!access.test_and_set) {
    check_answer(lines, access);
    if (access.answered) {
      CHECK(lines.value("data", access.end - k_tick) == access.data);
    }
  }
}

}  // namespace

TEST_CASE("every handshake stands on the lines where its access was") {
  RandomBench bench("lined", busy_bus(), k_signal_level);
  LineLog lines;
  bench.bus.observe_lines([&lines](const LineState& line) { lines.note(line); });
  sc_core::sc_start();
  REQUIRE(bench.log.size() > 100);
  Duration strobed{};
  int errors = 0;
  for (const BusAccess& access : bench.log) {
    INFO("request " << access.request.count() << ", grant " << access.grant.count());
    check_arbitration(lines, access, bench.bus.master_place(access.master).level);
    check_transfer(lines, access);
    strobed += access.end - access.grant;
    errors += access.answered ? 0 : 1;
  }
  CHECK(errors > 5);
  CHECK(lines.low("AS_n") == strobed);
  CHECK(lines.low("DS0_n") < strobed);
}

TEST_CASE("all lines are shown as they are before anything happens, by their names") {
  RandomBench bench("named", busy_bus(), k_signal_level);
  LineLog lines;
  int last = -1;
  bench.bus.observe_lines([&lines, &last](const LineState& line) {
    if (lines.count() <= static_cast<std::size_t>(line.line)) {
      CHECK(line.line == last + 1);
      CHECK(line.value == (line.name.back() == 'n' ? 1U : 0U));
      last = line.line;
    }
    lines.note(line);
  });
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  CHECK(lines.count() == 25);
  CHECK(lines.bits("BCLR_n") == 1);
  CHECK(lines.bits("BGOUT_named_master4_n") == 1);
  CHECK(lines.bits("address") == 32);
  CHECK(lines.bits("data") == 32);
}
