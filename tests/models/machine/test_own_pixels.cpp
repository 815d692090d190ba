#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "models/bus/bus_levels.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

/// Machines whose boards keep the pixels that they own, in an interlace.

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr std::uint32_t k_pixel_address = 0x1000;

MachineParameters interlaced(int boards) {
  MachineParameters parameters = machine(boards);
  parameters.allotment.order = Allotment::interlaced;
  parameters.board.ram_bytes = std::int64_t{128} * 1024;
  return parameters;
}

MachineParameters distributed(MachineParameters parameters) {
  parameters.frame_memory.place = FramePlace::boards;
  return parameters;
}

FrameSetup kept(FrameSetup setup) {
  setup.pixel_address = k_pixel_address;
  setup.keep_log = true;
  return setup;
}

/// A machine with a central frame memory, and the same with one on its boards.
struct Pair {
  Pair(const std::string& name, const MachineParameters& parameters, const FrameSetup& setup)
      : central(name, parameters, setup),
        own(name + "_own", distributed(parameters), kept(setup)),
        store{interlace_of(parameters.allotment, static_cast<int>(parameters.boards.size())),
              parameters.frame_memory.width, parameters.frame_memory.height, k_pixel_address} {}

  Run central;
  Run own;
  PixelStore store;
};

void check_statistics(const MachineStatistics& statistics, std::int64_t pixels) {
  for (const BoardStatistics& board : statistics.boards) {
    CHECK(board.compute + board.wait_grant + board.transfer + board.idle == statistics.frame_time);
    CHECK(board.idle >= Duration::zero());
    CHECK(board.words == 0);
    CHECK(board.wait_grant + board.transfer == Duration::zero());
    pixels -= board.pixels;
  }
  CHECK(pixels == 0);
  CHECK(total(statistics.bus).transfers == 0);
}

/// Each pixel is in the RAM of its board, and on the display as the boards have it.
void check_rams(const Pair& pair, const PixelRectangle& zone) {
  const Picture picture = pair.own.machine.frame_memory().picture();
  for (int row = zone.row0; row < zone.row0 + zone.height; ++row) {
    for (int column = zone.column0; column < zone.column0 + zone.width; ++column) {
      const auto board = static_cast<std::size_t>(pair.store.interlace.board_of({column, row}));
      const std::vector<unsigned char>& ram = pair.own.machine.board(board).ram();
      const std::uint64_t address = pair.store.address_of({column, row});
      REQUIRE(address + PixelStore::k_pixel_bytes <= k_pixel_address + pair.store.bytes());
      const std::uint32_t rgb =
          ram[address] * 0x10000U + ram[address + 1] * 0x100U + ram[address + 2];
      REQUIRE(rgb == colour({column, row}));
      REQUIRE(rgb == picture.pixels[static_cast<std::size_t>(row * picture.width + column)]);
    }
  }
}

void check_log(const Run& run, std::size_t pixels) {
  const std::vector<PixelWriteRecord>& log = run.machine.frame_memory().log();
  CHECK(log.size() == pixels);
  CHECK(std::is_sorted(log.begin(), log.end(),
                       [](const auto& a, const auto& b) { return a.instant < b.instant; }));
  CHECK((log.empty() || log.back().instant <= *run.machine.finished()));
}

}  // namespace

TEST_CASE("pixels that boards keep make the same picture without the bus") {
  std::mt19937 generator(16);
  std::vector<std::unique_ptr<Pair>> pairs;
  std::vector<PixelRectangle> zones;
  for (int one = 0; one < 60; ++one) {
    MachineParameters parameters = interlaced(1 + below(generator, 12));
    parameters.bus.level = k_bus_levels[below(generator, 4)];
    parameters.frame_memory.video_priority = below(generator, 2) == 0;
    zones.push_back(
        {below(generator, 30), below(generator, 20), below(generator, 30), below(generator, 25)});
    pairs.push_back(
        std::make_unique<Pair>("machine" + std::to_string(one), parameters, zone(zones.back())));
  }
  sc_core::sc_start();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pair& pair = *pairs[i];
    REQUIRE(pair.own.machine.finished());
    pair.own.machine.verify_frame();
    CHECK(pair.own.machine.frame_memory().picture().pixels ==
          pair.central.machine.frame_memory().picture().pixels);
    check_statistics(pair.own.machine.statistics(), zones[i].pixels());
    check_rams(pair, zones[i]);
    check_log(pair.own, static_cast<std::size_t>(zones[i].pixels()));
  }
}

TEST_CASE("a pixel of its own takes a board two writes of its RAM, and a read to compare depths") {
  std::array<std::unique_ptr<Run>, 2> runs;
  MachineParameters parameters = distributed(interlaced(2));
  parameters.board.ram_write_wait_clocks = 3;
  parameters.board.ram_read_wait_clocks = 5;
  parameters.board.word_gap_clocks = 7;
  for (const bool compares : {false, true}) {
    FrameMemoryParameters& memory = parameters.frame_memory;
    memory.red_bits = memory.blue_bits = 4;
    memory.depth_bits = 16;
    memory.depth_compare = compares;
    runs[compares ? 1 : 0] = std::make_unique<Run>(compares ? "compares" : "writes", parameters,
                                                   kept(zone({3, 5, 7, 1})));
  }
  sc_core::sc_start();
  for (const bool compares : {false, true}) {
    const BoardStatistics board = runs[compares ? 1 : 0]->machine.statistics().boards[0];
    Duration work = 5000 * k_clock;
    for (int column = 4; column < 10; column += 2) {
      work += (uneven_work({column, 5}) + 2 * (4 + 3) + 7 + (compares ? 4 + 5 : 0)) * k_clock;
    }
    CHECK(board.pixels == 3);
    CHECK(board.compute == work);
  }
}

TEST_CASE("the pixels of a board have places of their own in its RAM, as few as there are") {
  std::mt19937 generator(17);
  for (int trial = 0; trial < 200; ++trial) {
    const PixelStore store{{1 + below(generator, 6), 1 + below(generator, 6)},
                           1 + below(generator, 40),
                           1 + below(generator, 40),
                           k_pixel_address};
    std::vector<std::vector<int>> uses(
        static_cast<std::size_t>(store.interlace.columns * store.interlace.lines),
        std::vector<int>(store.bytes() / PixelStore::k_pixel_bytes));
    for (int row = 0; row < store.height; ++row) {
      for (int column = 0; column < store.width; ++column) {
        const auto board = static_cast<std::size_t>(store.interlace.board_of({column, row}));
        const std::uint64_t offset = store.address_of({column, row}) - k_pixel_address;
        REQUIRE(++uses[board].at(offset / PixelStore::k_pixel_bytes) == 1);
      }
    }
    CHECK(std::count(uses[0].begin(), uses[0].end(), 0) == 0);
  }
}

TEST_CASE("a board keeps no pixel of another's") {
  const MachineParameters parameters = distributed(interlaced(2));
  Run run("other", parameters, kept(zone({0, 0, 0, 0})));
  FrameMemory display("display", parameters.frame_memory, VideoTiming(parameters.video, 64, 48), 0,
                      false);
  const PixelStore store{{2, 1}, 64, 48};
  const OwnPixels pixels(store, 1, display);
  std::vector<unsigned char> ram(store.bytes());
  CHECK_THROWS_AS(pixels.keep({4, 0}, 0, {}, ram), std::logic_error);
  CHECK_NOTHROW(pixels.keep({5, 0}, 0, {}, ram));
}

TEST_CASE("what makes no distributed frame memory is refused") {
  const auto refused = [](const char* name, const MachineParameters& parameters) {
    CHECK_THROWS_AS(Run(name, parameters, kept(zone({0, 0, 8, 8}))), std::invalid_argument);
  };
  MachineParameters parameters = distributed(interlaced(4));
  parameters.allotment.order = Allotment::tiles;
  refused("tiles", parameters);
  parameters = distributed(interlaced(4));
  parameters.allotment.assignment = Assignment::on_demand;
  refused("claimed", parameters);
  parameters = distributed(interlaced(4));
  parameters.frame_memory.ports = 2;
  refused("ports", parameters);
  parameters = distributed(interlaced(4));
  parameters.board.pixel_write = PixelWrite::line;
  refused("lines", parameters);
  parameters = distributed(interlaced(4));
  parameters.board.ram_bytes = k_pixel_address + 32 * 24 * 4 - 1;
  refused("small", parameters);
  parameters.board.ram_bytes += 1;
  CHECK_NOTHROW(Run("fits", parameters, kept(zone({0, 0, 8, 8}))));
}
