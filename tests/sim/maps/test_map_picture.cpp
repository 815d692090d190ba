#include "sim/maps/map_picture.hpp"

#include <cmath>
#include <random>

#include "sim/picture/image_file.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

/// Facts of a zone of 3 x 2 pixels, one of which is not written.
PixelFacts small_facts() {
  PixelFacts facts;
  facts.width = 20;
  facts.height = 10;
  facts.zone = {4, 5, 3, 2};
  facts.boards = {"board0", "board1"};
  facts.times.resize(6);
  facts.written.assign(6, models::k_never);
  for (int i = 0; i < 5; ++i) {
    const auto place = static_cast<std::size_t>(i);
    facts.times[place].board = i % 2;
    facts.times[place].spent = {models::Duration(3'000'000 * i), models::Duration(1'000'000), {}};
    facts.written[place] = models::Duration(7'000'000);
  }
  return facts;
}

Map map_named(const std::string& name) { return maps_named({name}).front(); }

TEST_CASE("Marks of a scale are round, lie within it and are neither few nor many") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-9, 9);
  for (int i = 0; i < 1000; ++i) {
    const double range = std::pow(10, exponent(random));
    const double low = i % 2 == 0 ? 0 : -range * std::abs(exponent(random));
    const double high = low + range;
    const std::vector<double> marks = round_marks(low, high);
    INFO(low << " to " << high);
    CHECK(marks.size() >= 2);
    CHECK(marks.size() <= 7);
    for (const double mark : marks) {
      CHECK(mark >= low - 1e-6 * (high - low));
      CHECK(mark <= high + 1e-6 * (high - low));
    }
  }
  CHECK(round_marks(0, 10) == std::vector<double>{0, 2, 4, 6, 8, 10});
}

TEST_CASE("A map is drawn in a unit of few digits, from zero, with what is not known left out") {
  const MapDrawing drawing = drawing_of(map_named("time"), small_facts(), "small");
  CHECK(drawing.unit == "us");
  CHECK(drawing.low == 0);
  CHECK(drawing.high == Approx(13));
  CHECK(drawing.values[1] == Approx(4));
  CHECK(std::isnan(drawing.values[5]));
  CHECK(drawing.subtitle == "small: columns 4 to 6, rows 5 to 6 of 20 x 10");
  CHECK(drawing.names.empty());
}

TEST_CASE("Few names have a legend in place of a scale, many have numbers") {
  PixelFacts facts = small_facts();
  const MapDrawing drawing = drawing_of(map_named("board"), facts, "");
  CHECK(drawing.names == facts.boards);
  CHECK(drawing.ticks.empty());
  facts.boards.resize(100);
  CHECK(drawing_of(map_named("board"), facts, "").names.empty());
}

TEST_CASE("Pictures of maps are PNG files that hold every map's zone, whatever its size") {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {700, 3}, {2, 600}}) {
    PixelFacts facts = small_facts();
    facts.zone = {0, 0, width, height};
    facts.width = width;
    facts.height = height;
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    facts.times.resize(pixels);
    facts.written.assign(pixels, models::Instant(5));
    for (const char* name : {"time", "board", "written"}) {
      const models::Picture picture =
          decode_png(map_picture(map_named(name), facts, "scene"), name);
      CHECK(picture.width > width);
      CHECK(picture.height > height);
      CHECK(picture.at(0, 0) == 0xFFFFFF);
    }
  }
}

}  // namespace
}  // namespace maquette::sim
