#include <algorithm>
#include <memory>
#include <set>

#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr std::uint64_t k_shared_base = 0x840000;  // behind a frame memory of 64 x 48

MachineParameters on_demand(int boards, Allotment order) {
  MachineParameters parameters = machine(boards);
  parameters.allotment = cut_into(order, 6, 5);
  parameters.allotment.assignment = Assignment::on_demand;
  return parameters;
}

TEST_CASE("one board: a claim in closed form") {
  const std::uint32_t work = 1000;
  std::vector<std::unique_ptr<Run>> runs;
  for (const int width : {16, 32}) {
    MachineParameters parameters = on_demand(1, Allotment::interleaved_lines);
    parameters.bus.data_width_bits = width;
    runs.push_back(std::make_unique<Run>("one" + std::to_string(width), parameters,
                                         zone({3, 5, 20, 10}),
                                         [](PixelPosition /*position*/) { return work; }));
  }
  sc_core::sc_start();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const int long_accesses = run == 0 ? 2 : 1;
    const MachineStatistics statistics = runs[run]->machine.statistics();
    const BoardStatistics& board = statistics.boards[0];
    // Steps besides the bus; test-and-set with its change; counter read and written; lock cleared.
    const Duration steps = (16 + 22 + 6 + 24) * k_clock;
    const Duration cycle = 2 * k_word + 2 * k_clock;
    const Duration transfer = cycle + (2 * long_accesses + 1) * k_word;
    const Duration grants = (2 + 2 * long_accesses) * 4 * k_clock;
    const Duration claim = steps + transfer + grants;
    const Duration pixel =
        (work + 4 * long_accesses + (long_accesses - 1) * 6) * k_clock + long_accesses * k_word;
    CHECK(board.claims == 11);  // ten lines and none
    CHECK(board.failed_tries == 0);
    CHECK(board.claiming == 11 * claim);
    CHECK(board.words == 11 * (2 + 2 * long_accesses) + 200 * long_accesses);
    CHECK(statistics.frame_time == 5000 * k_clock + 11 * claim + 200 * pixel);
    check_states(statistics);
    CHECK_NOTHROW(runs[run]->machine.verify_frame());
  }
}

TEST_CASE("any machine on demand: each unit is claimed once, in the order of time") {
  std::mt19937 generator(64);
  std::vector<std::unique_ptr<Run>> runs;
  std::vector<std::int64_t> units;
  std::vector<std::vector<BusAccess>> counter_writes(60);
  for (std::size_t one = 0; one < 60; ++one) {
    const int boards = 1 + below(generator, 12);
    MachineParameters parameters = on_demand(boards, static_cast<Allotment>(below(generator, 4)));
    parameters.bus.data_width_bits = below(generator, 2) == 1 ? 16 : 32;
    parameters.bus.arbitration = k_arbitration_policies[below(generator, 2)];
    parameters.board.release = static_cast<ReleasePolicy>(below(generator, 2));
    parameters.board.pixel_write = static_cast<PixelWrite>(below(generator, 2));
    const PixelRectangle rectangle{below(generator, 20), below(generator, 20), below(generator, 30),
                                   below(generator, 25)};
    units.push_back(PixelAllotment(parameters.allotment, rectangle, boards).units());
    FrameSetup setup = zone(rectangle);
    if (one % 3 == 0) {
      setup.images.assign(static_cast<std::size_t>(boards), std::vector<unsigned char>(20));
    }
    const std::uint32_t scale = 1U + static_cast<std::uint32_t>(below(generator, 3)) * 10U;
    runs.push_back(std::make_unique<Run>(
        "any" + std::to_string(one), parameters, setup,
        [scale](PixelPosition position) { return uneven_work(position) / scale; }));
    runs.back()->machine.observe_bus([&log = counter_writes[one]](const BusAccess& access) {
      if (access.write && access.address == k_shared_base + SharedWindow::k_next_unit_offset) {
        log.push_back(access);
      }
    });
  }
  sc_core::sc_start();
  std::int64_t failed = 0;
  for (std::size_t one = 0; one < runs.size(); ++one) {
    INFO("machine " << one);
    const MachineStatistics statistics = runs[one]->machine.statistics();
    const auto boards = static_cast<std::int64_t>(statistics.boards.size());
    std::int64_t claims = 0;
    REQUIRE(statistics.has_finished);
    for (const BoardStatistics& board : statistics.boards) {
      claims += board.claims;
      failed += board.failed_tries;
      CHECK(board.claiming <= board.compute + board.wait_grant + board.transfer);
    }
    CHECK(claims == units[one] + boards);
    check_states(statistics);
    CHECK_NOTHROW(runs[one]->machine.verify_frame());
    const std::int64_t loaded = statistics.host.words > 0 ? 1 : 0;
    CHECK(static_cast<std::int64_t>(counter_writes[one].size()) == claims + loaded);
    CHECK(std::is_sorted(counter_writes[one].begin(), counter_writes[one].end(),
                         [](const auto& a, const auto& b) { return a.grant < b.grant; }));
  }
  CHECK(failed > 0);
}

TEST_CASE("units on demand level out work that a fixed share does not") {
  const auto lopsided = [](PixelPosition position) { return position.row < 12 ? 20'000U : 1000U; };
  MachineParameters parameters = on_demand(4, Allotment::interleaved_lines);
  Run demand("demand", parameters, zone({0, 0, 16, 48}), lopsided);
  parameters.allotment.order = Allotment::bands;
  parameters.allotment.assignment = Assignment::fixed;
  Run fixed("fixed", parameters, zone({0, 0, 16, 48}), lopsided);
  sc_core::sc_start();
  CHECK(2 * demand.machine.statistics().frame_time < fixed.machine.statistics().frame_time);
  CHECK(demand.machine.frame_memory().picture().pixels ==
        fixed.machine.frame_memory().picture().pixels);
}

TEST_CASE("tries that keep the holder of the lock off the bus end the run with the remedy") {
  MachineParameters parameters = on_demand(9, Allotment::interleaved_pixels);
  parameters.allotment.claim.spin_clocks = 0;
  Run run("starved", parameters, zone({0, 0, 64, 48}),
          [](PixelPosition position) { return static_cast<std::uint32_t>(position.column); });
  CHECK_THROWS_WITH(sc_core::sc_start(),
                    Catch::Matchers::ContainsSubstring("starved.board1 starves: ") &&
                        Catch::Matchers::ContainsSubstring("raise allotment.claim.spin"));
}

TEST_CASE("a machine with fixed shares has no shared memory") {
  Run run("plain", machine(2), zone({0, 0, 8, 8}));
  CHECK(run.machine.bus().address_map().find(k_shared_base) == AddressMap::k_unmapped);
  Run shared("shared", on_demand(2, Allotment::tiles), zone({0, 0, 8, 8}));
  CHECK(shared.machine.bus().address_map().find(k_shared_base) != AddressMap::k_unmapped);
}

}  // namespace
