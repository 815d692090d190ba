#include "sim/run/leg_teller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "models/unit/itinerary.hpp"
#include "sim/run/counted_source.hpp"
#include "tests/sim/description_files.hpp"
#include "tests/sim/record/random_legs.hpp"

using namespace maquette;
using namespace maquette::sim;
using firmware::Operation;
using models::PixelLeg;
using models::Stage;

namespace {

constexpr int k_width = 20;
constexpr int k_height = 15;

Description small(const std::string& scene) {
  return load_description(
      {data_directory() / "scenes" / scene,
       {},
       {fmt::format("frame_memory.width={} pixels", k_width),
        fmt::format("frame_memory.height={} pixels", k_height), "board.refresh_period=0 s"},
       data_directory().string()});
}

/// Scenes of every kind of ray, primitive and node that legs tell apart.
const std::vector<std::string> k_scenes = {"photo1.yaml",
                                           "photo2.yaml",
                                           "photo3.yaml",
                                           "photo4.yaml",
                                           "teapot.yaml",
                                           "operators/difference.yaml",
                                           "effects/refraction.yaml",
                                           "effects/nested_glass.yaml",
                                           "effects/orthographic.yaml",
                                           "effects/window.yaml",
                                           "effects/samples.yaml"};

/// A frame's pixels with their legs, as a source gives them.
struct ToldFrame {
  std::vector<models::SynthesizedPixel> pixels;
  std::vector<std::vector<PixelLeg>> legs;
  FrameWork work;
};

ToldFrame frame_of(const Description& description, int threads, LegsOfPixels told) {
  CountedSource source(
      packed_scene<firmware::Counted>(description.scene, picture_format_of(description.machine)),
      description.machine, threads, told);
  ToldFrame frame;
  for (int i = 0; i < source.useful_zone().pixels(); ++i) {
    frame.pixels.push_back(source.pixel(i));
    frame.legs.push_back(source.legs());
  }
  frame.work = source.work_by_function();
  return frame;
}

bool are_equal(const firmware::Work& a, const firmware::Work& b) {
  return std::equal(std::begin(a.counts), std::end(a.counts), std::begin(b.counts));
}

bool is_shadow(const PixelLeg& leg) { return leg.ray >= firmware::RayKind::shadow; }

/// What every leg holds to by itself.
void hold_leg(const PixelLeg& leg) {
  const bool is_board = leg.stage == Stage::board;
  CHECK((leg.numbers_in == 0) == is_board);
  CHECK((leg.numbers_out == 0) == is_board);
  CHECK(leg.work[Operation::leaf] == (leg.stage == Stage::intersection ? 1 : 0));
  CHECK(leg.work[Operation::combination] == (leg.stage == Stage::combination ? 1 : 0));
  if (leg.stage != Stage::extents) {
    CHECK(leg.work[Operation::node] == 0);
    CHECK(leg.work[Operation::sphere] + leg.work[Operation::box] == 0);
  }
  if (leg.stage != Stage::photometry) {
    CHECK(leg.work[Operation::light] + leg.work[Operation::facets] == 0);
  }
  CHECK_FALSE(are_equal(leg.work, {}));
}

}  // namespace

TEST_CASE("The legs of a pixel sum to its work, and each is of one stage") {
  for (const std::string& scene : k_scenes) {
    INFO(scene);
    const Description description = small(scene);
    const ToldFrame told = frame_of(description, 1, LegsOfPixels::told);
    REQUIRE(!told.legs.empty());
    for (std::size_t i = 0; i < told.pixels.size(); ++i) {
      REQUIRE(are_equal(sum_of(told.legs[i]), told.pixels[i].work));
      REQUIRE(told.legs[i].front().stage == Stage::board);
      REQUIRE(told.legs[i].back().stage == Stage::board);
      for (const PixelLeg& leg : told.legs[i]) {
        hold_leg(leg);
      }
    }
  }
}

TEST_CASE("Telling legs changes nothing else, nor does the number of threads change them") {
  for (const std::string& scene : k_scenes) {
    INFO(scene);
    const Description description = small(scene);
    const ToldFrame plain = frame_of(description, 1, LegsOfPixels::untold);
    const ToldFrame one = frame_of(description, 1, LegsOfPixels::told);
    const ToldFrame three = frame_of(description, 3, LegsOfPixels::told);
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
      REQUIRE(plain.legs[i].empty());
      REQUIRE(one.pixels[i].rgb == plain.pixels[i].rgb);
      REQUIRE(are_equal(one.pixels[i].work, plain.pixels[i].work));
      REQUIRE(are_equal(one.legs[i], three.legs[i]));
    }
    CHECK(numbers_of(one.work.pixels) == numbers_of(plain.work.pixels));
    CHECK(numbers_of(three.work.pixels) == numbers_of(plain.work.pixels));
  }
}

TEST_CASE("Legs that no unit does are one with those of the board around them, to the same hops") {
  const auto with_units = [](const std::string& scene, unsigned kinds) {
    Description description = small(scene);
    for (std::size_t kind = 0; kind < models::k_unit_kind_count; ++kind) {
      description.machine.parameters.units.kinds[kind].number = kinds >> kind & 1U;
    }
    return description;
  };
  const auto hops_of = [](const models::Itinerary& itinerary, const std::vector<PixelLeg>& legs) {
    std::vector<models::Hop> hops;
    itinerary.make(legs, hops);
    return hops;
  };
  for (const std::string& scene : k_scenes) {
    const ToldFrame all = frame_of(small(scene), 1, LegsOfPixels::told);
    for (const unsigned kinds : {1U, 2U, 4U, 8U, 16U, 10U, 15U, 18U, 31U}) {
      INFO(scene << " with kinds " << kinds);
      const Description description = with_units(scene, kinds);
      const models::Itinerary itinerary(description.machine.parameters.board,
                                        description.machine.parameters.units);
      const ToldFrame apart = frame_of(description, 1, LegsOfPixels::told);
      for (std::size_t i = 0; i < all.legs.size(); ++i) {
        REQUIRE(apart.legs[i].size() <= all.legs[i].size());
        const std::vector<models::Hop> hops = hops_of(itinerary, apart.legs[i]);
        const std::vector<models::Hop> expected = hops_of(itinerary, all.legs[i]);
        REQUIRE(hops.size() == expected.size());
        for (std::size_t hop = 0; hop < hops.size(); ++hop) {
          REQUIRE(hops[hop].kind == expected[hop].kind);
          REQUIRE(hops[hop].time == expected[hop].time);
          if (hops[hop].kind != models::Hop::k_at_board) {
            REQUIRE(hops[hop].numbers_in == expected[hop].numbers_in);
            REQUIRE(hops[hop].numbers_out == expected[hop].numbers_out);
          }
        }
      }
    }
  }
}

TEST_CASE("Legs follow the ray of a pixel, its crossings and the light's ray") {
  const Description description = load_text(
      R"(
view: {eye: [0, -5, 0], target: [0, 0, 0], up: [0, 0, 1], field_of_view: 5 deg}
lights: {key: {position: [5, -6, 8], intensity: [1, 1, 1]}}
surfaces: {red: {diffuse: [1, 0, 0]}}
object: {sphere: {radius: 1}, surface: red}
)",
      {"frame_memory.width=3 pixels", "frame_memory.height=3 pixels", "board.refresh_period=0 s"});
  const ToldFrame frame = frame_of(description, 1, LegsOfPixels::told);
  const std::vector<PixelLeg>& legs = frame.legs.at(4);
  const std::vector<Stage> stages = {Stage::board,      Stage::extents, Stage::intersection,
                                     Stage::photometry, Stage::extents, Stage::photometry,
                                     Stage::board};
  REQUIRE(legs.size() == stages.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    CHECK(legs[i].stage == stages[i]);
    CHECK(is_shadow(legs[i]) == (i == 4));
  }
  // Direction and pixel, and the root; the way to the leaf.
  CHECK(legs[1].numbers_in == 3 + 1 + 1);
  CHECK(legs[1].numbers_out == 2);
  // Direction and leaf; two hits.
  CHECK(legs[2].numbers_in == 3 + 1);
  CHECK(legs[2].numbers_out == 1 + 2 * 2);
  // Ray, weight, depth, two crossings; what is kept, and a ray.
  CHECK(legs[3].numbers_in == 4 + 3 + 1 + 1 + 2 * 3);
  CHECK(legs[3].numbers_out == 10 + 6 + 1 + 9);
  // A ray and the root; the answer.
  CHECK(legs[4].numbers_in == 9 + 1);
  CHECK(legs[4].numbers_out == 2);
  // What was kept and the light; a colour.
  CHECK(legs[5].numbers_in == 10 + 6 + 1 + 4);
  CHECK(legs[5].numbers_out == 3);
}

TEST_CASE("A thread has one teller, and another one after it") {
  {
    const LegTeller teller;
    CHECK_THROWS_AS(LegTeller(), std::logic_error);
    std::thread([] { const LegTeller of_another; }).join();
  }
  LegTeller teller;
  firmware::reset_counted_work();
  firmware::charge<firmware::Counted>(Operation::pixel);
  teller.start();
  CHECK(teller.take().empty());
  teller.start();
  firmware::charge<firmware::Counted>(Operation::pixel, 3);
  REQUIRE(teller.take().size() == 1);
  firmware::reset_counted_work();
  teller.start();
  firmware::charge<firmware::Counted>(Operation::pixel, 2);
  const std::vector<PixelLeg> legs = teller.take();
  REQUIRE(legs.size() == 1);
  CHECK(legs[0].work[Operation::pixel] == 2);
}

TEST_CASE("A part that counts nothing is no leg and parts none") {
  using firmware::Counted;
  firmware::reset_counted_work();
  LegTeller teller;
  teller.start();
  const auto part = [](Stage stage, std::uint32_t nodes, auto inside) {
    const firmware::InLeg<Counted> leg(stage, [] { return firmware::LegMessages{1, 2, 3, 4}; });
    firmware::charge<Counted>(Operation::node, nodes);
    inside();
    firmware::charge<Counted>(Operation::node, nodes);
  };
  part(Stage::extents, 1, [&] { part(Stage::photometry, 0, [] {}); });
  part(Stage::extents, 1, [&] { part(Stage::photometry, 5, [] {}); });
  const std::vector<PixelLeg> legs = teller.take();
  REQUIRE(legs.size() == 4);
  CHECK(legs[0].work[Operation::node] == 2);
  CHECK(legs[0].numbers_in == 1);
  CHECK(legs[0].numbers_out == 2);
  CHECK(legs[1].work[Operation::node] == 1);
  CHECK(legs[1].numbers_out == 3);
  CHECK(legs[2].stage == Stage::photometry);
  CHECK(legs[2].work[Operation::node] == 10);
  CHECK(legs[3].numbers_in == 4);
}

TEST_CASE("As many words are handed over as a leg can tell, and of more is told") {
  using firmware::Counted;
  firmware::reset_counted_work();
  LegTeller teller;
  const auto hand = [&teller](int given, int returned) {
    teller.start();
    {
      const firmware::InLeg<Counted> leg(Stage::combination, [=] {
        return firmware::LegMessages{given, returned};
      });
      firmware::charge<Counted>(Operation::node);
    }
    return teller.take();
  };
  CHECK_THROWS_AS(hand(65536, 1), std::overflow_error);
  CHECK_THROWS_AS(hand(1, 65536), std::overflow_error);
  const std::vector<PixelLeg> legs = hand(65535, 65535);
  REQUIRE(legs.size() == 1);
  CHECK(legs[0].numbers_in == 65535);
  CHECK(legs[0].numbers_out == 65535);
}
