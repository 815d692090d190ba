#include <algorithm>
#include <memory>

#include "models/board/database_cache.hpp"
#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;
using maquette::firmware::Operation;

// Loads besides the branches, as many as the position says.
class LoadingPixels : public AllottedPixels {
 public:
  LoadingPixels(const PixelAllotment& allotment, std::function<std::uint32_t(PixelPosition)> loads)
      : AllottedPixels(allotment, colour, uneven_work, 5000), loads_(std::move(loads)) {}

  const SynthesizedPixel& pixel(std::int64_t index) override {
    pixel_ = AllottedPixels::pixel(index);
    pixel_.work[Operation::load] = loads_({pixel_.column, pixel_.row});
    return pixel_;
  }

 private:
  std::function<std::uint32_t(PixelPosition)> loads_;
  SynthesizedPixel pixel_{};
};

struct Machine {
  Machine(const std::string& name, const MachineParameters& parameters, const FrameSetup& setup,
          std::function<std::uint32_t(PixelPosition)> loads)
      : source(PixelAllotment(parameters.allotment, setup.useful_zone,
                              static_cast<int>(parameters.boards.size())),
               std::move(loads)),
        machine(name.c_str(), parameters, source, setup) {}

  LoadingPixels source;
  CcettMachine machine;
};

// A load of 16 clocks and 4 reads without wait states.
MachineParameters sharing(int boards) {
  MachineParameters parameters = machine(boards);
  parameters.board.arithmetic.operations[static_cast<std::size_t>(Operation::load)] = {16, 4, 0};
  parameters.board.ram_read_wait_clocks = 2;
  parameters.board.database = DatabasePlace::shared;
  return parameters;
}

FrameSetup with_database(const PixelRectangle& rectangle, std::size_t bytes) {
  FrameSetup setup = zone(rectangle);
  setup.shared_database.assign(bytes, 0x3C);
  return setup;
}

TEST_CASE("one board: a shared database in closed form") {
  constexpr std::uint32_t k_loads = 37;
  std::vector<std::unique_ptr<Machine>> runs;
  for (const int width : {16, 32}) {
    MachineParameters parameters = sharing(1);
    parameters.bus.data_width_bits = width;
    runs.push_back(std::make_unique<Machine>("one" + std::to_string(width), parameters,
                                             with_database({0, 0, 10, 10}, 100),
                                             [](PixelPosition /*position*/) { return k_loads; }));
  }
  sc_core::sc_start();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const int words = run == 0 ? 2 : 1;
    const MachineStatistics statistics = runs[run]->machine.statistics();
    const BoardStatistics& board = statistics.boards[0];
    Duration compute = 5000 * k_clock;
    for (int pixel = 0; pixel < 100; ++pixel) {
      // Of a load 8 clocks and 2 reads with their waits stay with the processor.
      compute += (uneven_work({pixel % 10, pixel / 10}) + k_loads * (8 + 2 * 2)) * k_clock;
      compute += (words - 1) * 6 * k_clock;  // between the words of the pixel
    }
    CHECK(board.compute == compute);
    CHECK(board.database_words == 100 * k_loads * words);
    CHECK(board.words == board.database_words + 100 * words);
    CHECK(board.transfer == board.words * k_word);
    CHECK(board.wait_grant == board.words * 4 * k_clock);
    check_states(statistics);
    CHECK_NOTHROW(runs[run]->machine.verify_frame());
  }
}

TEST_CASE("the reads of a pixel are spread evenly over its time, to a tick") {
  Machine run("even", sharing(1), with_database({0, 0, 4, 4}, 1000), [](PixelPosition position) {
    return static_cast<std::uint32_t>(position.column * 7);
  });
  std::vector<BusAccess> log;
  run.machine.observe_bus([&log](const BusAccess& access) { log.push_back(access); });
  sc_core::sc_start();
  // Gaps between the long words of a pixel; a write ends a pixel.
  Duration least = Duration::max();
  Duration most{};
  int spans = 0;
  std::size_t first = 0;
  for (std::size_t at = 0; at < log.size(); ++at) {
    if (!log[at].write) {
      const bool second_word = (at - first) % 2 == 1;
      const Duration gap = log[at].request - (at == 0 ? 5000 * k_clock : log[at - 1].end);
      if (second_word) {
        CHECK(gap == Duration::zero());
      } else if (at > first) {
        least = std::min(least, gap);
        most = std::max(most, gap);
      }
      continue;
    }
    if (least != Duration::max()) {
      CHECK(most - least <= k_tick);
      const Duration last = log[at].request - log[at - 1].end;
      if (!log[at - 1].write) {
        CHECK(last >= least);
        CHECK(last <= most);
        ++spans;
      }
    }
    least = Duration::max();
    most = Duration::zero();
    first = at + 1;
  }
  CHECK(spans == 12);  // three columns of four read
}

TEST_CASE("any machine with a shared database verifies, and hides nothing") {
  std::mt19937 generator(5);
  std::vector<std::unique_ptr<Machine>> runs;
  for (int one = 0; one < 60; ++one) {
    const int boards = 1 + below(generator, 9);
    MachineParameters parameters = sharing(boards);
    parameters.allotment = cut_into(static_cast<Allotment>(below(generator, 4)), 5, 3);
    parameters.allotment.assignment = static_cast<Assignment>(below(generator, 2));
    const bool fixed = parameters.allotment.assignment == Assignment::fixed;
    parameters.frame_memory.ports = fixed ? 1 + below(generator, 3) : 1;
    parameters.board.database_cache_bytes = below(generator, 3) * 200;
    parameters.board.release = static_cast<ReleasePolicy>(below(generator, 2));
    parameters.board.pixel_write = static_cast<PixelWrite>(below(generator, 2));
    parameters.board.refresh_period = Duration{15'000'000};
    parameters.bus.data_width_bits = below(generator, 2) == 1 ? 16 : 32;
    parameters.bus.arbitration = k_arbitration_policies[below(generator, 2)];
    parameters.frame_memory.video_priority = below(generator, 2) == 1;
    FrameSetup setup = with_database(
        {below(generator, 20), below(generator, 20), below(generator, 20), below(generator, 20)},
        10 + 2 * static_cast<std::size_t>(below(generator, 300)));
    if (one % 2 == 1) {
      setup.images.assign(static_cast<std::size_t>(boards), std::vector<unsigned char>(33));
    }
    const std::uint32_t most = 1U + static_cast<std::uint32_t>(below(generator, 60));
    for (const char* twin : {"a", "b"}) {
      runs.push_back(std::make_unique<Machine>(
          twin + std::to_string(one), parameters, setup, [most](PixelPosition position) {
            return static_cast<std::uint32_t>(position.column * 31 + position.row * 17) % most;
          }));
    }
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < runs.size(); ++one) {
    INFO("machine " << one);
    const MachineStatistics statistics = runs[one]->machine.statistics();
    const MachineStatistics twin = runs[one ^ 1U]->machine.statistics();
    REQUIRE(statistics.has_finished);
    check_states(statistics);
    CHECK_NOTHROW(runs[one]->machine.verify_frame());
    CHECK(statistics.frame_time == twin.frame_time);
    CHECK(statistics.bus.waited_for == twin.bus.waited_for);
  }
}

TEST_CASE("a cache as large as the database is read once into, and then no more") {
  DatabaseCache cache(4096, 1000);
  std::int64_t misses = 0;
  for (int pixel = 0; pixel < 100; ++pixel) {
    misses += cache.misses(50);
  }
  CHECK(misses == 250);
}

TEST_CASE("without a cache every load misses; with one the share of its size hits, exactly") {
  DatabaseCache none(0, 1000);
  CHECK(none.misses(123) == 123);
  std::mt19937 generator(3);
  for (int one = 0; one < 300; ++one) {
    const std::int64_t database = 4 + below(generator, 5000);
    const std::int64_t size = below(generator, 6000);
    const std::int64_t cached = std::min(database, size);
    DatabaseCache cache(size, database);
    std::int64_t loads = 0;
    std::int64_t misses = 0;
    for (int pixel = 0; pixel < 200; ++pixel) {
      const std::int64_t some = below(generator, 300);
      const std::int64_t missed = cache.misses(some);
      REQUIRE(missed >= 0);
      REQUIRE(missed <= some);
      loads += some;
      misses += missed;
      const std::int64_t of_law = loads * (database - cached) / database;
      REQUIRE(misses == of_law + std::min(cached / 4, loads - of_law));
    }
  }
}

TEST_CASE("a shared database must be given") {
  AllottedPixels source(PixelAllotment({}, {}, 1), colour, uneven_work, 0);
  CHECK_THROWS_AS(CcettMachine("none", sharing(1), source, zone({0, 0, 1, 1})),
                  std::invalid_argument);
  CHECK_THROWS_AS(CcettMachine("copy", machine(1), source, with_database({0, 0, 1, 1}, 8)),
                  std::invalid_argument);
  MachineParameters cheap = sharing(1);
  cheap.board.database_read.clocks = 100;
  CHECK_THROWS_WITH(CcettMachine("cheap", cheap, source, with_database({0, 0, 1, 1}, 8)),
                    Catch::Matchers::ContainsSubstring("database_read"));
}

}  // namespace
