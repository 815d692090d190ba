#include <memory>
#include <random>
#include <string>
#include <vector>

#include "models/bus/bus_levels.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

/// What observers of pixels are told.

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

/// What the pixels of each board took together, and how often each was told.
struct Told {
  std::vector<ProcessorTime> boards;
  std::vector<int> pixels;

  Told(CcettMachine& machine, std::size_t board_count, const PixelRectangle& zone)
      : boards(board_count), pixels(static_cast<std::size_t>(zone.pixels())) {
    machine.observe_pixels([this, zone](const PixelTime& pixel) {
      ProcessorTime& sum = boards.at(static_cast<std::size_t>(pixel.board));
      sum.compute += pixel.spent.compute;
      sum.wait += pixel.spent.wait;
      sum.transfer += pixel.spent.transfer;
      const int place =
          (pixel.position.row - zone.row0) * zone.width + pixel.position.column - zone.column0;
      ++pixels.at(static_cast<std::size_t>(place));
    });
  }
};

void check_told(const Told& told, const MachineStatistics& statistics) {
  for (const int times : told.pixels) {
    CHECK(times == 1);
  }
  for (std::size_t i = 0; i < told.boards.size(); ++i) {
    INFO("board " << i);
    const BoardStatistics& board = statistics.boards[i];
    CHECK(told.boards[i].compute == board.compute - board.preprocessing);
    CHECK(told.boards[i].wait == board.wait_grant);
    CHECK(told.boards[i].transfer == board.transfer);
  }
}

}  // namespace

TEST_CASE("What pixels took sums to what their boards did, at every level and way of writing") {
  std::mt19937 random(3);
  const PixelRectangle zone_of_pixels{5, 7, 23, 17};
  const Allotment orders[] = {Allotment::interleaved_pixels, Allotment::interleaved_lines,
                              Allotment::bands, Allotment::tiles, Allotment::interlaced};
  std::vector<std::unique_ptr<Run>> runs;
  std::vector<std::unique_ptr<Told>> told;
  for (int i = 0; i < 24; ++i) {
    const int boards = 1 + static_cast<int>(random() % 6);
    MachineParameters parameters = machine(boards);
    parameters.allotment = cut_into(orders[random() % std::size(orders)], 5, 3);
    parameters.board.pixel_write = random() % 2 == 0 ? PixelWrite::pixel : PixelWrite::line;
    parameters.board.release =
        random() % 2 == 0 ? ReleasePolicy::each_access : ReleasePolicy::block;
    parameters.bus.level = k_bus_levels[random() % std::size(k_bus_levels)];
    runs.push_back(
        std::make_unique<Run>("machine" + std::to_string(i), parameters, zone(zone_of_pixels)));
    told.push_back(std::make_unique<Told>(runs.back()->machine, static_cast<std::size_t>(boards),
                                          zone_of_pixels));
  }
  sc_core::sc_start();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    INFO("machine " << i);
    check_told(*told[i], runs[i]->machine.statistics());
  }
}

TEST_CASE("Boards that keep their pixels tell of them without a bus") {
  MachineParameters parameters = machine(3);
  parameters.allotment.order = Allotment::interlaced;
  parameters.board.ram_bytes = std::int64_t{128} * 1024;
  parameters.frame_memory.place = FramePlace::boards;
  const PixelRectangle zone_of_pixels{0, 0, 20, 10};
  Run run("machine", parameters, zone(zone_of_pixels));
  const Told told(run.machine, 3, zone_of_pixels);
  sc_core::sc_start();
  check_told(told, run.machine.statistics());
}
