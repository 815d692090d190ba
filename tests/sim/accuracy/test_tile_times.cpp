#include "sim/accuracy/tile_times.hpp"

#include "sim/accuracy/tile_error.hpp"
#include "sim/report/seconds.hpp"
#include "sim/run/simulation.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette;
using namespace maquette::sim;

namespace {

Description small_description(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(),
                   {"frame_memory.width=96 pixels", "frame_memory.height=72 pixels"});
  return load_description(
      {data_directory() / "scenes/photo4.yaml", {}, overrides, data_directory().string()});
}

models::Picture empty_picture(const Machine& machine) {
  const models::FrameMemoryParameters& frame = machine.parameters.frame_memory;
  return {frame.width, frame.height,
          std::vector<std::uint32_t>(static_cast<std::size_t>(frame.width * frame.height))};
}

TileTimes counted(const Description& description, int share) {
  return counted_tile_times(description.scene, description.machine, share);
}

TileTimes executed(const Description& description, int share) {
  models::Picture picture = empty_picture(description.machine);
  return executed_tile_times(description.scene, description.machine, share, picture);
}

}  // namespace

TEST_CASE("the counted tiles together take what the boards of a machine compute on them") {
  const Description description =
      small_description({"board.word_gap=0 clocks", "board.costs=tables"});
  const SimulationResult result = simulate(description.scene, description.machine, {},
                                           [](models::Duration, double) { return true; });
  models::Duration computed{};
  for (const BoardStatistics& board : result.statistics.boards) {
    computed += board.compute - result.statistics.frame.preprocess;
  }
  CHECK(counted(description, 1).sum() == computed);
}

TEST_CASE("the executed tiles have the picture that the machine makes of them") {
  const Description description = small_description();
  const SimulationResult result = simulate(description.scene, description.machine, {},
                                           [](models::Duration, double) { return true; });
  models::Picture picture = result.picture;
  for (std::uint32_t& pixel : picture.pixels) {
    pixel = pixel == result.picture.pixels[0] ? pixel : 0x123456;
  }
  const TileTimes tiles = executed_tile_times(description.scene, description.machine, 1, picture);
  CHECK(picture.pixels == result.picture.pixels);
  for (const models::Duration time : tiles.times) {
    CHECK(time > models::Duration::zero());
  }
}

TEST_CASE("a sample tells the ratio of executed and counted times of the whole") {
  const Description description = small_description();
  const double whole =
      in_seconds(executed(description, 1).sum()) / in_seconds(counted(description, 1).sum());
  for (const int share : {2, 4, 8, 16}) {
    const double sampled = in_seconds(executed(description, share).sum()) /
                           in_seconds(counted(description, share).sum());
    INFO("1 in " << share);
    CHECK(sampled == Approx(whole).epsilon(0.01));
  }
}

TEST_CASE("a broken price shows as an error of every tile") {
  const TileTimes reference = executed(small_description(), 1);
  const Description broken = small_description({"board.call_overhead.clocks=5200"});
  for (const std::optional<double>& error : tile_error(counted(broken, 1), reference).relative) {
    REQUIRE(error.has_value());
    CHECK(*error > 1);
  }
  CHECK(tile_error(counted(small_description(), 1), reference).worst < 1);
}
