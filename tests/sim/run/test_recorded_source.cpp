#include "sim/run/recorded_source.hpp"

#include "sim/run/counted_source.hpp"
#include "sim/run/frame_pixels.hpp"
#include "sim/run/frame_recorder.hpp"
#include "tests/sim/description_files.hpp"
#include "tests/sim/record/random_legs.hpp"

using namespace maquette;
using namespace maquette::sim;

namespace {

Description small(const std::string& scene, const std::string& order) {
  return load_description({data_directory() / "scenes" / scene,
                           {},
                           {"frame_memory.width=40 pixels", "frame_memory.height=30 pixels",
                            "board.refresh_period=0 s", "allotment.order=" + order},
                           data_directory().string()});
}

RecordedFrame recorded(const Description& description, int threads, LegsOfPixels legs) {
  return record_frame(description.scene, picture_format_of(description.machine), threads,
                      FunctionsOfPixels::untold, legs);
}

}  // namespace

TEST_CASE("A recorded frame gives the pixels and legs of a direct run, in the machine's order") {
  for (const char* scene : {"photo1.yaml", "photo4.yaml", "effects/nested_glass.yaml"}) {
    for (const char* order : {"interleaved_pixels", "tiles"}) {
      INFO(scene << ' ' << order);
      const Description description = small(scene, order);
      const RecordedFrame record = recorded(description, 1, LegsOfPixels::told);
      REQUIRE(record.has_legs());
      REQUIRE(legs_make_pixels(record));
      const auto of = [&](const RecordedFrame* replayed) {
        return frame_pixels(description.scene, description.machine, replayed, false, 2,
                            LegsOfPixels::told);
      };
      const FramePixels direct = of(nullptr);
      const FramePixels replay = of(&record);
      REQUIRE(direct.zone.pixels() == replay.zone.pixels());
      for (int i = 0; i < direct.zone.pixels(); ++i) {
        REQUIRE(direct.source->pixel(i).rgb == replay.source->pixel(i).rgb);
        REQUIRE(are_equal(direct.legs->legs(), replay.legs->legs()));
      }
    }
  }
}

TEST_CASE("The legs of a record are the same by any number of threads, and only where asked for") {
  const Description description = small("photo2.yaml", "interleaved_pixels");
  const RecordedFrame one = recorded(description, 1, LegsOfPixels::told);
  CHECK(recorded(description, 3, LegsOfPixels::told).legs.words() == one.legs.words());
  const RecordedFrame without = recorded(description, 2, LegsOfPixels::untold);
  CHECK_FALSE(without.has_legs());
  CHECK(numbers_of(without.by_function.pixels) == numbers_of(one.by_function.pixels));
  const auto pixels = [&](LegsOfPixels legs) {
    return frame_pixels(description.scene, description.machine, &without, false, 1, legs);
  };
  CHECK(pixels(LegsOfPixels::untold).legs == nullptr);
  CHECK_THROWS_AS(pixels(LegsOfPixels::told), std::logic_error);
}
