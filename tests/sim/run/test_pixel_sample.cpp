#include "sim/run/pixel_sample.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/catch.hpp"

using namespace maquette::sim;
using namespace maquette::models;

namespace {

int draw(std::mt19937& random, int least, int most) {
  return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
}

Machine random_machine(std::mt19937& random) {
  Machine machine;
  AllotmentParameters& allotment = machine.parameters.allotment;
  const Allotment orders[] = {Allotment::interleaved_pixels, Allotment::interleaved_lines,
                              Allotment::bands, Allotment::tiles, Allotment::interlaced};
  allotment.order = orders[random() % 5];
  allotment.assignment = random() % 2 == 0 ? Assignment::fixed : Assignment::on_demand;
  allotment.tile_width = draw(random, 1, 20);
  allotment.tile_height = draw(random, 1, 20);
  return machine;
}

PixelRectangle random_zone(std::mt19937& random) {
  return {draw(random, 0, 50), draw(random, 0, 50), draw(random, 1, 80), draw(random, 1, 60)};
}

}  // namespace

TEST_CASE("a sample has no pixel twice and none outside, and one in one is all of them") {
  std::mt19937 random(71);
  for (int round = 0; round < 200; ++round) {
    const Machine machine = random_machine(random);
    const PixelRectangle zone = random_zone(random);
    const int share = draw(random, 1, 12);
    const PixelSample sample = pixel_sample(machine, zone, share);
    CHECK(sample.step >= share);
    std::set<std::pair<int, int>> pixels;
    for (const PixelPosition& pixel : pixels_of(sample, zone)) {
      REQUIRE(pixels.insert({pixel.column, pixel.row}).second);
      REQUIRE((pixel.column >= zone.column0 && pixel.column < zone.column0 + zone.width));
      REQUIRE((pixel.row >= zone.row0 && pixel.row < zone.row0 + zone.height));
    }
    const auto whole = pixels_of(pixel_sample(machine, zone, 1), zone);
    CHECK(static_cast<std::int64_t>(whole.size()) == zone.pixels());
    CHECK(pixels.size() <= whole.size());
  }
}

TEST_CASE(
    "a sample of interleaved pixels has of each column as many as of another, give or take 1") {
  std::mt19937 random(72);
  for (int round = 0; round < 200; ++round) {
    const PixelRectangle zone = random_zone(random);
    const PixelSample sample = pixel_sample(Machine{}, zone, draw(random, 1, 30));
    std::map<int, int> columns;
    for (int column = 0; column < zone.width; ++column) {
      columns[zone.column0 + column] = 0;
    }
    for (const PixelPosition& pixel : pixels_of(sample, zone)) {
      ++columns[pixel.column];
    }
    const auto [least, most] =
        std::minmax_element(columns.begin(), columns.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; });
    CHECK(most->second - least->second <= 1);
  }
}
