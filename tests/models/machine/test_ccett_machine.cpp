#include <memory>
#include <stdexcept>

#include "models/bus/arbitration_policies.hpp"
#include "models/machine/ccett_machine.hpp"
#include "models/machine/unique_names.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

TEST_CASE("one board: the frame time in closed form") {
  const std::uint32_t work = 1000;
  struct Case {
    int width;
    ReleasePolicy release;
    Duration grants;    // of one pixel
    Duration transfer;  // of one pixel
    Duration gaps;
  };
  const Case cases[] = {
      {16, ReleasePolicy::each_access, 2 * 4 * k_clock, 2 * k_word, 6 * k_clock},
      {16, ReleasePolicy::block, 4 * k_clock, 2 * k_word, 6 * k_clock},
      {32, ReleasePolicy::each_access, 4 * k_clock, k_word, Duration::zero()},
      {32, ReleasePolicy::block, 4 * k_clock, k_word, Duration::zero()},
  };
  std::vector<std::unique_ptr<Run>> runs;
  for (const Case& one : cases) {
    MachineParameters parameters = machine(1);
    parameters.board.release = one.release;
    parameters.bus.data_width_bits = one.width;
    runs.push_back(std::make_unique<Run>("one" + std::to_string(runs.size()), parameters,
                                         zone({3, 5, 20, 10}),
                                         [](PixelPosition /*position*/) { return work; }));
  }
  sc_core::sc_start();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const Case& one = cases[run];
    const MachineStatistics statistics = runs[run]->machine.statistics();
    const BoardStatistics& board = statistics.boards[0];
    INFO("run " << run);
    CHECK(statistics.load_time == Duration::zero());
    CHECK(statistics.frame_time ==
          5000 * k_clock + 200 * (work * k_clock + one.grants + one.transfer + one.gaps));
    CHECK(board.compute == 5000 * k_clock + 200 * (work * k_clock + one.gaps));
    CHECK(board.wait_grant == 200 * one.grants);
    CHECK(board.transfer == 200 * one.transfer);
    CHECK(board.preprocessing == 5000 * k_clock);
    CHECK(board.pixels == 200);
    CHECK(board.work.shadow == 800);
    CHECK(board.work.operations[static_cast<std::size_t>(maquette::firmware::Operation::node)] ==
          200 * work);
    check_states(statistics);
    CHECK_NOTHROW(runs[run]->machine.verify_frame());
  }
}

TEST_CASE("any machine: states sum to the frame time, each useful pixel is written once") {
  std::mt19937 generator(21);
  std::vector<std::unique_ptr<Run>> runs;
  std::vector<PixelRectangle> zones;
  for (int one = 0; one < 60; ++one) {
    MachineParameters parameters = machine(1 + below(generator, 9));
    parameters.allotment = cut_into(static_cast<Allotment>(below(generator, 4)), 5, 5);
    parameters.allotment.assignment = static_cast<Assignment>(below(generator, 2));
    parameters.board.release = static_cast<ReleasePolicy>(below(generator, 2));
    parameters.board.pixel_write = static_cast<PixelWrite>(below(generator, 2));
    parameters.board.refresh_period = Duration{15'000'000};
    parameters.bus.data_width_bits = below(generator, 2) == 1 ? 16 : 32;
    parameters.bus.arbitration = k_arbitration_policies[below(generator, 2)];
    parameters.frame_memory.video_priority = below(generator, 2) == 1;
    const PixelRectangle rectangle{below(generator, 20), below(generator, 20), below(generator, 45),
                                   below(generator, 29)};
    FrameSetup setup = zone(rectangle);
    setup.background = 0x010203;
    if (one % 2 == 1) {
      setup.images.assign(parameters.boards.size(), std::vector<unsigned char>(333, 7));
    }
    zones.push_back(rectangle);
    runs.push_back(std::make_unique<Run>("any" + std::to_string(one), parameters, setup));
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < runs.size(); ++one) {
    const CcettMachine& machine = runs[one]->machine;
    const MachineStatistics statistics = machine.statistics();
    INFO("machine " << one);
    REQUIRE(statistics.has_finished);
    check_states(statistics);
    CHECK_NOTHROW(machine.verify_frame());
    std::int64_t pixels = 0;
    for (const BoardStatistics& board : statistics.boards) {
      pixels += board.pixels;
    }
    CHECK(pixels == zones[one].pixels());
    const Picture picture = machine.frame_memory().picture();
    for (int row = 0; row < picture.height; ++row) {
      for (int column = 0; column < picture.width; ++column) {
        const PixelRectangle& z = zones[one];
        const bool useful = column >= z.column0 && column < z.column0 + z.width && row >= z.row0 &&
                            row < z.row0 + z.height;
        REQUIRE(picture.at(column, row) == (useful ? colour({column, row}) : 0x010203));
      }
    }
  }
}

TEST_CASE("the host's load is one loop and one access per word, and arrives") {
  MachineParameters parameters = machine(3);
  FrameSetup setup = zone({0, 0, 4, 4});
  setup.images = {std::vector<unsigned char>(1001), {}, std::vector<unsigned char>(64, 0x5A)};
  for (std::size_t byte = 0; byte < 1001; ++byte) {
    setup.images[0][byte] = static_cast<unsigned char>(byte * 7);
  }
  Run run("loaded", parameters, setup);
  std::vector<BusAccess> log;
  run.machine.observe_bus([&log](const BusAccess& access) { log.push_back(access); });
  sc_core::sc_start();
  const MachineStatistics statistics = run.machine.statistics();
  // 501 and 32 words: the loop's clocks, arbitration, 10 clocks for RAM of 625 ns.
  const int words = 501 + 32;
  CHECK(statistics.host.words == words);
  CHECK(statistics.load_time == words * (22 + 4 + 10) * k_clock);
  check_states(statistics);
  CHECK(log.front().address == 0x40000);
  CHECK(log[500].address == 0x40000 + 1000);
  CHECK(log[501].address == 0xC0000);
  CHECK(log[533].request > statistics.load_time);
}

TEST_CASE("a line of pixels is one burst per row, with the same picture") {
  MachineParameters parameters = machine(2);
  parameters.board.release = ReleasePolicy::block;
  Run pixel("pixel", parameters, zone({0, 0, 16, 8}));
  parameters.board.pixel_write = PixelWrite::line;
  Run line("line", parameters, zone({0, 0, 16, 8}));
  sc_core::sc_start();
  const auto arbitrations = [](const Run& run) {
    return total(run.machine.statistics().bus).arbitration / (4 * k_clock);
  };
  // One grant per row and board instead of one per pixel (and some hand-overs).
  CHECK(arbitrations(pixel) >= 16 * 8);
  CHECK(arbitrations(line) >= 16);
  CHECK(arbitrations(line) < 2 * 16);
  CHECK(line.machine.frame_memory().picture().pixels ==
        pixel.machine.frame_memory().picture().pixels);
}

TEST_CASE("a fixed share is every n-th unit, in order") {
  constexpr int k_boards = 3;
  std::vector<std::unique_ptr<Run>> runs;
  std::vector<std::vector<std::vector<std::uint64_t>>> written(4);  // by order and board
  for (int order = 0; order < 4; ++order) {
    MachineParameters parameters = machine(k_boards);
    parameters.allotment = cut_into(static_cast<Allotment>(order), 5, 4);
    parameters.bus.data_width_bits = 32;
    runs.push_back(
        std::make_unique<Run>("share" + std::to_string(order), parameters, zone({7, 3, 23, 19})));
    auto& boards = written[static_cast<std::size_t>(order)];
    boards.resize(k_boards);
    runs.back()->machine.observe_bus([&boards](const BusAccess& access) {
      boards[static_cast<std::size_t>(access.master)].push_back((access.address - 0x800000) / 4);
    });
  }
  sc_core::sc_start();
  for (int order = 0; order < 4; ++order) {
    const PixelAllotment cut(cut_into(static_cast<Allotment>(order), 5, 4), {7, 3, 23, 19},
                             k_boards);
    for (int board = 0; board < k_boards; ++board) {
      std::vector<std::uint64_t> expected;
      for (std::int64_t unit = board; unit < cut.units(); unit += k_boards) {
        for (auto index = cut.first_pixel(unit); index < cut.first_pixel(unit + 1); ++index) {
          const PixelPosition position = cut.position(index);
          expected.push_back(static_cast<std::uint64_t>(position.row * 64 + position.column));
        }
      }
      CHECK(written[static_cast<std::size_t>(order)][static_cast<std::size_t>(board)] == expected);
    }
  }
}

TEST_CASE("a run that is interrupted still accounts for all of its time") {
  Run run("cut", machine(4), zone({0, 0, 64, 48}));
  for (int slice = 0; slice < 50; ++slice) {
    sc_core::sc_start(1'234'567, sc_core::SC_NS);
    const MachineStatistics statistics = run.machine.statistics();
    for (const BoardStatistics& board : statistics.boards) {
      REQUIRE(board.compute + board.wait_grant + board.transfer + board.idle ==
              statistics.frame_time);
    }
  }
  CHECK_THROWS_AS(run.machine.verify_frame(), std::logic_error);
  sc_core::sc_start();
  CHECK(run.machine.statistics().has_finished);
  CHECK_NOTHROW(run.machine.verify_frame());
}

TEST_CASE("a bus error ends the run with master, address and instant") {
  MachineParameters parameters = machine(1);
  parameters.frame_memory.access_time = Duration{65'000'000};
  Run run("faulty", parameters, zone({1, 0, 4, 4}));
  CHECK_THROWS_WITH(sc_core::sc_start(),
                    Catch::Matchers::ContainsSubstring("bus error: master faulty.board0") &&
                        Catch::Matchers::ContainsSubstring("0x800004") &&
                        Catch::Matchers::ContainsSubstring("804375 ns"));
}

TEST_CASE("two machines of the same name are an error") {
  require_unique_names();
  Run first("twin", machine(1), zone({0, 0, 1, 1}));
  CHECK_THROWS_WITH(Run("twin", machine(1), zone({0, 0, 1, 1})),
                    Catch::Matchers::ContainsSubstring("already exists"));
}

TEST_CASE("what makes no machine is refused") {
  AllottedPixels source(PixelAllotment({}, {}, 1), colour, uneven_work, 0);
  CHECK_THROWS_AS(CcettMachine("none", machine(0), source, zone({0, 0, 1, 1})),
                  std::invalid_argument);
  CHECK_THROWS_AS(CcettMachine("outside", machine(1), source, zone({60, 0, 5, 1})),
                  std::invalid_argument);
  FrameSetup large = zone({0, 0, 1, 1});
  large.images.assign(1, std::vector<unsigned char>(128 * 1024 + 1));
  CHECK_THROWS_AS(CcettMachine("large", machine(1), source, large), std::invalid_argument);
}

}  // namespace
