#include <memory>
#include <random>
#include <vector>

#include "models/bus/bus_levels.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

/// Machines whose video reader is elaborated, beside the same ones without.

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

MachineParameters random_machine(std::mt19937& generator) {
  MachineParameters parameters = machine(1 + below(generator, 7));
  parameters.bus.level = k_bus_levels[below(generator, 4)];
  parameters.board.release =
      below(generator, 2) == 0 ? ReleasePolicy::each_access : ReleasePolicy::block;
  parameters.board.pixel_write = below(generator, 2) == 0 ? PixelWrite::pixel : PixelWrite::line;
  FrameMemoryParameters& memory = parameters.frame_memory;
  memory.width = 256;
  memory.height = 575;
  memory.ports = 1 + below(generator, 3);
  memory.video_priority = below(generator, 8) != 0;
  memory.video_slot_pixels = 8 + below(generator, 16);
  memory.video_slot_time = Duration{100'000 + below(generator, 200'000)};
  memory.access_time = Duration{below(generator, 200'000)};
  return parameters;
}

/// A machine without and one with a reader that is watched for part of its frame.
struct Pair {
  Pair(const std::string& name, const MachineParameters& parameters, const FrameSetup& setup,
       Duration from, Duration to)
      : plain(name, parameters, setup),
        watched(name + "_watched", parameters, setup),
        reader(watched.machine.watch_video(from, to)) {
    watched.machine.observe_memory([this, from, to](const MemoryAccess& access) {
      accesses += access.asked >= from && access.begun < to ? 1 : 0;
      delayed += access.begun > access.asked ? 1 : 0;
    });
  }

  Run plain;
  Run watched;
  VideoReader& reader;
  std::int64_t accesses = 0;
  std::int64_t delayed = 0;
};

void check_equal(const MachineStatistics& one, const MachineStatistics& other) {
  REQUIRE(one.has_finished);
  REQUIRE(one.frame_time == other.frame_time);
  for (std::size_t board = 0; board < one.boards.size(); ++board) {
    REQUIRE(one.boards[board].compute == other.boards[board].compute);
    REQUIRE(one.boards[board].wait_grant == other.boards[board].wait_grant);
    REQUIRE(one.boards[board].transfer == other.boards[board].transfer);
    REQUIRE(one.boards[board].idle == other.boards[board].idle);
  }
}

}  // namespace

TEST_CASE("a video reader that is watched finds each wait of the machine, and changes none") {
  std::mt19937 generator(1984);
  std::vector<std::unique_ptr<Pair>> pairs;
  for (int one = 0; one < 40; ++one) {
    const MachineParameters parameters = random_machine(generator);
    const FrameSetup setup = zone({below(generator, 200), 5, 20 + below(generator, 30), 20});
    const Duration from = one % 2 == 0 ? Duration{} : Duration{below(generator, 2'000'000'000)};
    const Duration to =
        one % 3 == 0 ? k_never : from + Duration{1 + below(generator, 2'000'000'000)};
    pairs.push_back(
        std::make_unique<Pair>("machine" + std::to_string(one), parameters, setup, from, to));
  }
  sc_core::sc_start();
  std::int64_t delayed = 0;
  std::int64_t compared = 0;
  for (const auto& pair : pairs) {
    const MachineStatistics statistics = pair->plain.machine.statistics();
    check_states(statistics);
    check_equal(statistics, pair->watched.machine.statistics());
    // The last ones may come with the end of the frame, at which nobody looks any more.
    CHECK(pair->reader.compared() <= pair->accesses);
    CHECK(pair->reader.compared() >= pair->accesses - 200);
    delayed += pair->delayed;
    compared += pair->reader.compared();
  }
  CHECK(delayed > 1000);
  CHECK(compared > 20'000);
}
