#include "sim/run/executed_pixels.hpp"

#include <vector>

#include "models/display/pixel_format.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/pixel_sample.hpp"
#include "sim/run/simulation.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette;
using namespace maquette::sim;

namespace {

Description coarse(std::vector<std::string> overrides) {
  overrides.insert(overrides.end(),
                   {"frame_memory.width=48 pixels", "frame_memory.height=36 pixels"});
  return load_description(
      {data_directory() / "scenes/photo4.yaml", {}, overrides, data_directory().string()});
}

std::vector<ExecutedPixel> executed(const Description& description, int share) {
  std::vector<ExecutedPixel> pixels;
  execute_pixels(description.scene, description.machine, share, [&pixels](const auto& pixel) {
    pixels.push_back(pixel);
    return true;
  });
  return pixels;
}

void check_sample(const std::vector<std::string>& overrides, int share) {
  const Description description = coarse(overrides);
  const Machine& machine = description.machine;
  const PreparedScene<firmware::Counted> scene(
      packed_scene<firmware::Counted>(description.scene, picture_format_of(machine)));
  SynthesisArea<firmware::Counted> area(scene.frame().database);
  const models::PixelFormat format(machine.parameters.frame_memory);
  const models::PixelRectangle zone = useful_zone_of(scene.frame());
  const auto expected = pixels_of(pixel_sample(machine, zone, share), zone);
  const std::vector<ExecutedPixel> pixels = executed(description, share);
  REQUIRE(pixels.size() == expected.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    REQUIRE(pixels[i].position.column == expected[i].column);
    REQUIRE(pixels[i].position.row == expected[i].row);
    const models::SynthesizedPixel pixel = counted_pixel(scene.frame(), area.view(), expected[i]);
    CHECK(pixels[i].bytes == format.written(pixel.rgb, pixel.depth));
    CHECK(pixels[i].time > models::Duration::zero());
  }
}

models::Duration sum_of(const std::vector<ExecutedPixel>& pixels) {
  models::Duration sum{};
  for (const ExecutedPixel& pixel : pixels) {
    sum += pixel.time;
  }
  return sum;
}

}  // namespace

TEST_CASE("a board alone writes the sample's pixels, in their order, as the firmware has them") {
  for (const int share : {1, 5}) {
    for (const char* allotment :
         {"interleaved_pixels", "interleaved_lines", "bands", "tiles", "interlaced"}) {
      INFO(allotment << ", 1 in " << share);
      check_sample({std::string("allotment.order=") + allotment}, share);
    }
    check_sample({"board.arithmetic=maquette_ffp", "allotment.assignment=on_demand"}, share);
    check_sample({"board.pixel_write=line"}, share);
    check_sample({"board.arithmetic=ieee_single"}, share);
  }
}

TEST_CASE("its pixels together take what the board of a machine computes on them") {
  const Description description = coarse({"processors=1"});
  SimulationRequest request;
  request.executed = true;
  const Statistics statistics =
      simulate(description.scene, description.machine, request, [](models::Duration, double) {
        return true;
      }).statistics;
  const models::Duration computed = statistics.boards[0].compute - statistics.frame.preprocess;
  const models::Duration rest = computed - sum_of(executed(description, 1));
  CHECK(rest >= models::Duration::zero());  // from the last pixel to the program's end
  CHECK(rest < std::chrono::milliseconds(1));
}

TEST_CASE("the taker of pixels ends the execution") {
  int taken = 0;
  const Description description = coarse({});
  execute_pixels(description.scene, description.machine, 1,
                 [&taken](const ExecutedPixel&) { return ++taken < 7; });
  CHECK(taken == 7);
}

TEST_CASE("what boards can not execute is refused with what to set") {
  const Description description = coarse({"board.arithmetic=mc68881"});
  try {
    executed(description, 1);
    FAIL("it is executed");
  } catch (const DescriptionError& error) {
    CHECK_THAT(error.what(), Catch::Matchers::ContainsSubstring("motorola_ffp"));
  }
}
