#include <algorithm>
#include <array>
#include <memory>

#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

MachineParameters with_ports(int boards, int ports) {
  MachineParameters parameters = machine(boards);
  parameters.frame_memory.ports = ports;
  return parameters;
}

TEST_CASE("with a port for each board none waits for another") {
  const std::uint32_t work = 20;
  Run shared("shared", with_ports(4, 1), zone({0, 0, 16, 16}),
             [](PixelPosition /*position*/) { return work; });
  Run apart("apart", with_ports(4, 4), zone({0, 0, 16, 16}),
            [](PixelPosition /*position*/) { return work; });
  sc_core::sc_start();
  const MachineStatistics statistics = apart.machine.statistics();
  CHECK(statistics.backplanes == 4);
  for (const BoardStatistics& board : statistics.boards) {
    CHECK(board.wait_grant == 64 * 2 * 4 * k_clock);  // arbitration of two words, no hand-over
    CHECK(board.compute + board.wait_grant + board.transfer ==
          5000 * k_clock + 64 * ((work + 2 * 4 + 6) * k_clock + 2 * k_word));
  }
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = 0; b < 5; ++b) {
      CHECK((a == b || statistics.bus.waited_for[a][b] == Duration::zero()));
    }
  }
  CHECK(statistics.frame_time < shared.machine.statistics().frame_time);
  CHECK(apart.machine.frame_memory().picture().pixels ==
        shared.machine.frame_memory().picture().pixels);
}

TEST_CASE("any number of ports: the frame verifies, states sum, the log is in order") {
  std::mt19937 generator(44);
  std::vector<std::unique_ptr<Run>> runs;
  std::vector<std::size_t> written;
  std::vector<std::array<std::int64_t, 10>> accesses(60);  // by board, then of the host
  for (std::size_t one = 0; one < 60; ++one) {
    const int boards = 1 + below(generator, 9);
    const int ports = 1 + below(generator, 5);
    MachineParameters parameters = with_ports(boards, ports);
    parameters.allotment = cut_into(static_cast<Allotment>(below(generator, 4)), 5, 3);
    parameters.board.release = static_cast<ReleasePolicy>(below(generator, 2));
    parameters.board.pixel_write = static_cast<PixelWrite>(below(generator, 2));
    parameters.bus.data_width_bits = below(generator, 2) == 1 ? 16 : 32;
    parameters.bus.arbitration = k_arbitration_policies[below(generator, 2)];
    parameters.frame_memory.video_priority = below(generator, 2) == 1;
    FrameSetup setup = zone(
        {below(generator, 20), below(generator, 20), below(generator, 30), below(generator, 25)});
    setup.keep_log = true;
    const std::size_t pixel_words = parameters.bus.data_width_bits == 16 ? 2 : 1;
    written.push_back(pixel_words * static_cast<std::size_t>(setup.useful_zone.pixels()));
    if (one % 2 == 1) {
      setup.images.assign(static_cast<std::size_t>(boards), std::vector<unsigned char>(333, 7));
    }
    runs.push_back(std::make_unique<Run>("any" + std::to_string(one), parameters, setup));
    runs.back()->machine.observe_bus([&counts = accesses[one]](const BusAccess& access) {
      ++counts[static_cast<std::size_t>(access.master)];
    });
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < runs.size(); ++one) {
    INFO("machine " << one);
    const CcettMachine& machine = runs[one]->machine;
    const MachineStatistics statistics = machine.statistics();
    REQUIRE(statistics.has_finished);
    check_states(statistics);
    CHECK_NOTHROW(machine.verify_frame());
    const auto& log = machine.frame_memory().log();
    CHECK(log.size() == written[one]);
    CHECK(std::is_sorted(log.begin(), log.end(),
                         [](const auto& a, const auto& b) { return a.instant < b.instant; }));
    const auto boards = statistics.boards.size();
    const auto ports = static_cast<std::size_t>(statistics.backplanes);
    for (std::size_t a = 0; a < boards; ++a) {
      CHECK(statistics.bus.masters[a].transfers == statistics.boards[a].words);
      CHECK(statistics.bus.masters[a].transfers == accesses[one][a]);
      CHECK(statistics.bus.masters[a].waited == statistics.boards[a].wait_grant);
      for (std::size_t b = 0; b < boards; ++b) {
        CHECK((a % ports == b % ports || statistics.bus.waited_for[a][b] == Duration::zero()));
      }
    }
    CHECK(statistics.bus.masters[boards].transfers == statistics.host.words);
    CHECK(accesses[one][boards] == statistics.host.words);
  }
}

TEST_CASE("what has no exact order on several backplanes is refused") {
  AllottedPixels source(PixelAllotment({}, {}, 2), colour, uneven_work, 0);
  MachineParameters parameters = with_ports(2, 2);
  parameters.allotment.assignment = Assignment::on_demand;
  CHECK_THROWS_AS(CcettMachine("demand", parameters, source, zone({0, 0, 1, 1})),
                  std::invalid_argument);
  CHECK_THROWS_AS(CcettMachine("none", with_ports(2, 0), source, zone({0, 0, 1, 1})),
                  std::invalid_argument);
}

}  // namespace
