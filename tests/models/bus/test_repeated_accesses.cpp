#include <memory>
#include <random>
#include <vector>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/memory_cells.hpp"
#include "models/bus/versabus.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

/// Accesses of a burst that are done in one go, against the same done one by one.

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr std::uint64_t k_base = 0x1000;
constexpr std::size_t k_bytes = 256;

/// A memory, or another's, that takes the same time for each access.
class Cells : public sc_core::sc_module {
 public:
  Cells(const sc_core::sc_module_name& name, Duration time) : sc_module(name), time_(time) {
    socket.register_b_transport(this, &Cells::b_transport);
  }

  tlm_utils::simple_target_socket<Cells> socket;
  std::vector<unsigned char> bytes = std::vector<unsigned char>(k_bytes);
  int calls = 0;

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    ++calls;
    access_cells(bytes, payload);
    delay += to_sc_time(time_);
  }

  Duration time_;
};

struct Script {
  BusMasterPlace place;
  Style style;
  std::vector<Step> steps;
};

/// Two memories side by side, so that bursts may cross from one to the other, or leave both.
struct CellBench {
  CellBench(const std::string& name, const VersaBusParameters& parameters, bool steady,
            const std::vector<Script>& scripts)
      : bus((name + "_bus").c_str(), parameters),
        first((name + "_first").c_str(), Duration{625'000}),
        second((name + "_second").c_str(), Duration{100'000}) {
    bus.attach_slave(first.socket, {"first", k_base, k_bytes, steady});
    bus.attach_slave(second.socket, {"second", k_base + k_bytes, k_bytes, steady});
    for (const Script& one : scripts) {
      masters.push_back(
          std::make_unique<Master>((name + "_master" + std::to_string(masters.size())).c_str(), bus,
                                   one.place, board_access(), one.style, script(one.steps)));
    }
  }

  VersaBus bus;
  Cells first;
  Cells second;
  std::vector<std::unique_ptr<Master>> masters;
};

std::vector<Script> random_scripts(std::mt19937& generator) {
  std::vector<Script> scripts;
  const int masters = 1 + below(generator, 4);
  for (int master = 0; master < masters; ++master) {
    Script one{{below(generator, 3), master}, static_cast<Style>(below(generator, 5)), {}};
    const int busy = below(generator, 2) == 0 ? 40 : 4000;
    for (int step = 1 + below(generator, 20); step > 0; --step) {
      Step& next = one.steps.emplace_back();
      next.compute = Duration{125'000LL * below(generator, busy)};
      next.address = k_base + 4 * static_cast<unsigned>(below(generator, 100));
      next.accesses = 1 + below(generator, 50);
      next.gap = Duration{125'000LL * below(generator, 8)};
      next.block = below(generator, 2) == 1;
      next.command = below(generator, 4) == 0 ? tlm::TLM_READ_COMMAND : tlm::TLM_WRITE_COMMAND;
      next.one_place = below(generator, 2) == 1;
    }
    scripts.push_back(std::move(one));
  }
  return scripts;
}

void check_same(const BusStatistics& one, const BusStatistics& other) {
  REQUIRE(one.masters.size() == other.masters.size());
  CHECK(one.waited_for == other.waited_for);
  CHECK(one.queue_times == other.queue_times);
  for (std::size_t i = 0; i < one.masters.size(); ++i) {
    const BusMasterStatistics& a = one.masters[i];
    const BusMasterStatistics& b = other.masters[i];
    CHECK(a.transfers == b.transfers);
    CHECK(a.delayed == b.delayed);
    CHECK(a.errors == b.errors);
    CHECK(a.busy == b.busy);
    CHECK(a.held == b.held);
    CHECK(a.arbitration == b.arbitration);
    CHECK(a.handover == b.handover);
    CHECK(a.waited == b.waited);
    CHECK(a.longest_wait == b.longest_wait);
    CHECK(a.longest_wait_request == b.longest_wait_request);
    CHECK(a.longest_wait_behind == b.longest_wait_behind);
    CHECK(a.waits.count() == b.waits.count());
    for (const int per_mille : {1, 500, 900, 1000}) {
      CHECK(a.waits.quantile(per_mille) == b.waits.quantile(per_mille));
    }
  }
}

void check_same(const Outcome& one, const Outcome& other) {
  CHECK(one.end == other.end);
  CHECK(one.waited == other.waited);
  CHECK(one.transferred == other.transferred);
  CHECK(one.longest_wait == other.longest_wait);
  CHECK(one.status == other.status);
}

}  // namespace

TEST_CASE("accesses of steady slaves that are done in one go change no tick and no byte") {
  constexpr int k_cases = 200;
  std::mt19937 generator(1984);
  std::vector<std::unique_ptr<CellBench>> one_by_one;
  std::vector<std::unique_ptr<CellBench>> in_one_go;
  for (int i = 0; i < k_cases; ++i) {
    VersaBusParameters parameters;
    parameters.arbitration = i % 2 == 0 ? k_priority : k_round_robin;
    parameters.arbitration_clocks = below(generator, 5);
    parameters.handover_clocks = below(generator, 3);
    parameters.data_width_bits = below(generator, 2) == 0 ? 16 : 32;
    const std::vector<Script> scripts = random_scripts(generator);
    const std::string name = "case" + std::to_string(i);
    one_by_one.push_back(std::make_unique<CellBench>(name + "_a", parameters, false, scripts));
    in_one_go.push_back(std::make_unique<CellBench>(name + "_b", parameters, true, scripts));
  }
  sc_core::sc_start();
  int calls = 0;
  int fewer_calls = 0;
  for (std::size_t i = 0; i < k_cases; ++i) {
    INFO("case " << i);
    const CellBench& a = *one_by_one[i];
    const CellBench& b = *in_one_go[i];
    check_same(a.bus.statistics(), b.bus.statistics());
    REQUIRE(a.first.bytes == b.first.bytes);
    REQUIRE(a.second.bytes == b.second.bytes);
    calls += a.first.calls + a.second.calls;
    fewer_calls += b.first.calls + b.second.calls;
    for (std::size_t master = 0; master < a.masters.size(); ++master) {
      const auto& outcomes = a.masters[master]->outcomes;
      REQUIRE(outcomes.size() == b.masters[master]->outcomes.size());
      for (std::size_t step = 0; step < outcomes.size(); ++step) {
        check_same(outcomes[step], b.masters[master]->outcomes[step]);
      }
    }
  }
  CHECK(fewer_calls < calls * 3 / 4);
}
