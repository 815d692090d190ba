#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "models/board/allotment.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using traffic::below;

// All but the interlace, whose units are no rectangles.
constexpr Allotment k_orders[] = {Allotment::interleaved_pixels, Allotment::interleaved_lines,
                                  Allotment::bands, Allotment::tiles};

PixelAllotment allotment(Allotment order, const PixelRectangle& zone, int boards,
                         int tile_width = 8, int tile_height = 8) {
  return {traffic::cut_into(order, tile_width, tile_height), zone, boards};
}

PixelRectangle random_zone(std::mt19937& generator) {
  return {below(generator, 50), below(generator, 50), below(generator, 40), below(generator, 40)};
}

// The pixels of a unit by the law of its order.
PixelRectangle unit_rectangle(Allotment order, const PixelRectangle& zone, int boards,
                              int tile_width, int tile_height, int unit) {
  const int start = zone.height * unit / boards;
  const int tiles_per_row = (zone.width + tile_width - 1) / tile_width;
  switch (order) {
    case Allotment::interleaved_pixels:
      return {unit % zone.width, unit / zone.width, 1, 1};
    case Allotment::interleaved_lines:
      return {0, unit, zone.width, 1};
    case Allotment::bands:
      return {0, start, zone.width, zone.height * (unit + 1) / boards - start};
    case Allotment::tiles:
    case Allotment::interlaced:
      break;
  }
  const int column = unit % tiles_per_row * tile_width;
  const int row = unit / tiles_per_row * tile_height;
  return {column, row, std::min(tile_width, zone.width - column),
          std::min(tile_height, zone.height - row)};
}

TEST_CASE("the units are those of the order, each row by row") {
  std::mt19937 generator(99);
  for (int one = 0; one < 300; ++one) {
    const PixelRectangle zone = random_zone(generator);
    const int boards = 1 + below(generator, 9);
    const int tile_width = 1 + below(generator, 12);
    const int tile_height = 1 + below(generator, 12);
    for (const Allotment order : k_orders) {
      const PixelAllotment cut = allotment(order, zone, boards, tile_width, tile_height);
      REQUIRE(cut.first_pixel(0) == 0);
      for (int unit = 0; unit < cut.units(); ++unit) {
        const PixelRectangle place =
            unit_rectangle(order, zone, boards, tile_width, tile_height, unit);
        std::int64_t index = cut.first_pixel(unit);
        for (std::int64_t k = 0; k < place.pixels(); ++k, ++index) {
          const PixelPosition position = cut.position(index);
          REQUIRE(position.column == zone.column0 + place.column0 + k % place.width);
          REQUIRE(position.row == zone.row0 + place.row0 + k / place.width);
        }
        REQUIRE(index == cut.first_pixel(unit + 1));
      }
      REQUIRE(cut.first_pixel(cut.units()) == zone.pixels());
    }
  }
}

TEST_CASE("every pixel of the zone has exactly one index") {
  std::mt19937 generator(97);
  for (int one = 0; one < 300; ++one) {
    const PixelRectangle zone = random_zone(generator);
    for (const Allotment order : k_orders) {
      const PixelAllotment cut = allotment(order, zone, 1 + below(generator, 9),
                                           1 + below(generator, 12), 1 + below(generator, 12));
      std::set<std::pair<int, int>> seen;
      REQUIRE(cut.pixels() == zone.pixels());
      for (std::int64_t index = 0; index < cut.pixels(); ++index) {
        const PixelPosition position = cut.position(index);
        REQUIRE(position.column >= zone.column0);
        REQUIRE(position.column < zone.column0 + zone.width);
        REQUIRE(position.row >= zone.row0);
        REQUIRE(position.row < zone.row0 + zone.height);
        REQUIRE(seen.insert({position.column, position.row}).second);
      }
    }
  }
}

TEST_CASE("no band has more than one row more than another") {
  std::mt19937 generator(98);
  for (int one = 0; one < 300; ++one) {
    const PixelRectangle zone{0, 0, 1 + below(generator, 100), 1 + below(generator, 100)};
    const PixelAllotment bands = allotment(Allotment::bands, zone, 1 + below(generator, 9));
    std::vector<std::int64_t> counts;
    for (std::int64_t band = 0; band < bands.units(); ++band) {
      counts.push_back(bands.first_pixel(band + 1) - bands.first_pixel(band));
    }
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    REQUIRE(*most - *least <= zone.width);
  }
}

TEST_CASE("what cannot be allotted is refused") {
  CHECK_THROWS_AS(allotment(Allotment::bands, {0, 0, 4, 4}, 0), std::invalid_argument);
  CHECK_THROWS_AS(allotment(Allotment::bands, {0, 0, -1, 4}, 1), std::invalid_argument);
  CHECK_THROWS_AS(allotment(Allotment::tiles, {0, 0, 4, 4}, 1, 0, 1), std::invalid_argument);
}

}  // namespace
