#include "sim/run/fact_synthesis.hpp"

#include <cmath>
#include <cstring>
#include <numeric>

#include "sim/maps/map_table.hpp"
#include "sim/run/frame_recorder.hpp"
#include "sim/run/simulation.hpp"
#include "tests/sim/description_files.hpp"

/// Laws of the facts that maps are taken from, on whole runs.
namespace maquette::sim {
namespace {

const std::vector<std::string> k_frame = {"frame_memory.width=48 pixels",
                                          "frame_memory.height=36 pixels"};

Description described(const std::string& scene, std::vector<std::string> overrides) {
  overrides.insert(overrides.end(), k_frame.begin(), k_frame.end());
  return load_description(
      {(data_directory() / scene).string(), {}, overrides, data_directory().string()});
}

SimulationRequest request_of(const std::vector<std::string>& names) {
  SimulationRequest request;
  request.facts = facts_of(maps_named(names));
  return request;
}

SimulationResult run(const Description& description, const SimulationRequest& request) {
  return simulate(description.scene, description.machine, request,
                  [](models::Duration, double) { return true; });
}

double sum_of(const std::string& name, const PixelFacts& facts) {
  const Map map = maps_named({name}).front();
  double sum = 0;
  for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(facts.zone.pixels()); ++pixel) {
    const double value = map.value(facts, pixel);
    sum += std::isnan(value) ? 0 : value;
  }
  return sum;
}

models::Duration sum_of(models::Duration BoardStatistics::*state, const Statistics& statistics) {
  models::Duration sum{};
  for (const BoardStatistics& board : statistics.boards) {
    sum += board.*state;
  }
  return sum;
}

void check_sums(const SimulationResult& result, models::Duration preprocessing) {
  const PixelFacts& facts = result.facts;
  const Statistics& statistics = result.statistics;
  const auto boards = static_cast<std::int64_t>(statistics.boards.size());
  const models::Duration computed =
      sum_of(&BoardStatistics::compute, statistics) - boards * preprocessing;
  CHECK(sum_of("compute", facts) == static_cast<double>(computed.count()));
  CHECK(sum_of("wait", facts) ==
        static_cast<double>(sum_of(&BoardStatistics::wait_grant, statistics).count()));
  CHECK(sum_of("transfer", facts) ==
        static_cast<double>(sum_of(&BoardStatistics::transfer, statistics).count()));
  CHECK(sum_of("time", facts) ==
        sum_of("compute", facts) + sum_of("wait", facts) + sum_of("transfer", facts));
  CHECK(sum_of("rays", facts) == static_cast<double>(statistics.rays.total));
  CHECK(sum_of("rays.shadow", facts) == static_cast<double>(statistics.rays.shadow));
  for (int i = 0; i < firmware::k_operation_count; ++i) {
    const std::string name = firmware::k_operation_names[i];
    CHECK(sum_of("work." + name, facts) ==
          static_cast<double>(statistics.work[static_cast<std::size_t>(i)]));
  }
  const ExtentStatistics& extents = statistics.extents;
  CHECK(sum_of("extents.met", facts) ==
        static_cast<double>(extents.rectangles.hits + extents.boxes.hits + extents.spheres.hits));
}

void check_functions(const PixelFacts& facts) {
  for (std::size_t pixel = 0; pixel < facts.functions.size(); ++pixel) {
    const auto& values = facts.functions[pixel].values;
    CHECK(std::accumulate(values.begin(), values.end(), models::Duration{}) ==
          facts.times[pixel].spent.compute);
  }
}

void check_boards(const Description& description, const PixelFacts& facts) {
  const auto boards = static_cast<int>(description.machine.parameters.boards.size());
  const models::PixelAllotment allotment(description.machine.parameters.allotment, facts.zone,
                                         boards);
  for (std::int64_t unit = 0; unit < allotment.units(); ++unit) {
    for (std::int64_t i = allotment.first_pixel(unit); i < allotment.first_pixel(unit + 1); ++i) {
      const models::PixelPosition place = allotment.position(i);
      const auto pixel = static_cast<std::size_t>((place.row - facts.zone.row0) * facts.zone.width +
                                                  place.column - facts.zone.column0);
      CHECK(facts.times[pixel].board == unit % boards);
      CHECK(facts.times[pixel].position.column == place.column);
    }
  }
}

const std::vector<std::string> k_all = {"time", "rays", "extents.met", "function.photometry",
                                        "surface"};

}  // namespace

TEST_CASE("Sums of maps are the totals of the run, boards those of the allotment") {
  const Description description =
      described("scenes/effects/nested_glass.yaml", {"processors=3", "allotment.order=tiles"});
  const SimulationResult result = run(description, request_of(k_all));
  // All boards prepare alike.
  check_sums(result, result.statistics.frame.preprocess);
  check_functions(result.facts);
  check_boards(description, result.facts);
  models::Instant last{};
  for (const models::Instant written : result.facts.written) {
    last = std::max(last, written);
  }
  // The board still has the bus for a moment.
  CHECK(last < result.statistics.frame.time);
  CHECK(last > result.statistics.frame.time - std::chrono::microseconds(2));
}

TEST_CASE("Lines that are written as blocks sum up as well") {
  const Description description = described(
      "scenes/effects/mirror.yaml",
      {"board.pixel_write=line", "board.release=block", "allotment.order=interleaved_lines"});
  const SimulationResult result = run(description, request_of(k_all));
  check_sums(result, result.statistics.frame.preprocess);
  check_boards(description, result.facts);
}

TEST_CASE("Executed boards tell of their pixels, and how far counts are from them") {
  const Description description = described("scenes/primitives/sphere.yaml", {});
  SimulationRequest request = request_of({"time", "count_error"});
  request.executed = true;
  const SimulationResult result = run(description, request);
  check_boards(description, result.facts);
  CHECK(sum_of("wait", result.facts) ==
        static_cast<double>(sum_of(&BoardStatistics::wait_grant, result.statistics).count()));
  const models::Duration computed = sum_of(&BoardStatistics::compute, result.statistics);
  CHECK(sum_of("compute", result.facts) < static_cast<double>(computed.count()));
  models::Duration counted{};
  for (const models::Duration pixel : result.facts.counted) {
    counted += pixel;
  }
  CHECK(static_cast<double>(counted.count()) ==
        Approx(sum_of("compute", result.facts)).epsilon(0.01));
}

TEST_CASE("A record has the facts of the run that it replaces") {
  const Description description = described("scenes/effects/mirror.yaml", {});
  SimulationRequest request = request_of({"time", "rays"});
  const RecordedFrame record =
      record_frame(description.scene, picture_format_of(description.machine), 1);
  request.record = &record;
  const SimulationResult result = run(description, request);
  PixelFacts again;
  again.zone = result.facts.zone;
  synthesise_facts(description.scene, description.machine, nullptr, request.facts, 2, again);
  REQUIRE(again.pixels.size() == result.facts.pixels.size());
  for (std::size_t pixel = 0; pixel < again.pixels.size(); ++pixel) {
    CHECK(std::memcmp(&again.pixels[pixel].work, &result.facts.pixels[pixel].work,
                      sizeof(firmware::Work)) == 0);
    CHECK(again.pixels[pixel].rays.primary == result.facts.pixels[pixel].rays.primary);
  }
}

TEST_CASE("Nothing is kept of pixels that nobody asked for") {
  const SimulationResult result = run(described("scenes/effects/mirror.yaml", {}), {});
  CHECK(result.facts.times.empty());
  CHECK(result.facts.pixels.empty());
  CHECK(result.facts.sights.empty());
}

}  // namespace maquette::sim
