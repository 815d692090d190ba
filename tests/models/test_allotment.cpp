#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "models/allotment.hpp"
#include "traffic.hpp"

namespace {

using namespace maquette::models;
using traffic::below;

constexpr Allotment k_kinds[] = {Allotment::interleaved_pixels, Allotment::interleaved_lines,
                                 Allotment::bands, Allotment::tiles};

TEST_CASE("every pixel of the zone belongs to exactly one board") {
  std::mt19937 generator(99);
  for (int one = 0; one < 300; ++one) {
    const PixelRectangle zone{below(generator, 50), below(generator, 50), below(generator, 40),
                              below(generator, 40)};
    const int boards = 1 + below(generator, 9);
    const int tile_width = 1 + below(generator, 12);
    const int tile_height = 1 + below(generator, 12);
    for (const Allotment kind : k_kinds) {
      const PixelAllotment allotment(kind, zone, boards, tile_width, tile_height);
      std::set<std::pair<int, int>> seen;
      std::int64_t pixels = 0;
      for (int board = 0; board < boards; ++board) {
        pixels += allotment.count(board);
        for (std::int64_t k = 0; k < allotment.count(board); ++k) {
          const PixelPosition position = allotment.pixel(board, k);
          REQUIRE(position.column >= zone.column0);
          REQUIRE(position.column < zone.column0 + zone.width);
          REQUIRE(position.row >= zone.row0);
          REQUIRE(position.row < zone.row0 + zone.height);
          REQUIRE(seen.insert({position.column, position.row}).second);
        }
      }
      REQUIRE(pixels == zone.pixels());
    }
  }
}

TEST_CASE("no board has more than one unit more than another") {
  std::mt19937 generator(98);
  for (int one = 0; one < 300; ++one) {
    const PixelRectangle zone{0, 0, 1 + below(generator, 100), 1 + below(generator, 100)};
    const int boards = 1 + below(generator, 9);
    const std::map<Allotment, std::int64_t> units{{Allotment::interleaved_pixels, 1},
                                                  {Allotment::interleaved_lines, zone.width},
                                                  {Allotment::bands, zone.width}};
    for (const auto& [kind, unit] : units) {
      const PixelAllotment allotment(kind, zone, boards, 8, 8);
      std::vector<std::int64_t> counts;
      for (int board = 0; board < boards; ++board) {
        counts.push_back(allotment.count(board));
      }
      const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
      REQUIRE(*most - *least <= unit);
    }
  }
}

TEST_CASE("who gets which pixel") {
  const PixelRectangle zone{10, 20, 5, 6};
  const PixelAllotment pixels(Allotment::interleaved_pixels, zone, 4, 1, 1);
  CHECK(pixels.pixel(1, 1).column == 10);  // index 5 of rows of 5
  CHECK(pixels.pixel(1, 1).row == 21);
  const PixelAllotment lines(Allotment::interleaved_lines, zone, 4, 1, 1);
  CHECK(lines.pixel(1, 5).row == 25);
  const PixelAllotment bands(Allotment::bands, zone, 4, 1, 1);
  CHECK(bands.count(0) == 5);
  CHECK(bands.count(1) == 10);
  CHECK(bands.pixel(1, 0).row == 21);
  const PixelAllotment tiles(Allotment::tiles, zone, 2, 2, 4);  // 3 x 2 tiles, right one 1 wide
  CHECK(tiles.count(0) == 8 + 4 + 4);
  CHECK(tiles.count(1) == 8 + 4 + 2);
  CHECK(tiles.pixel(1, 3).column == 13);
  CHECK(tiles.pixel(1, 3).row == 21);
  CHECK(tiles.pixel(0, 8).column == 14);  // third tile of the upper row
}

TEST_CASE("what cannot be allotted is refused") {
  CHECK_THROWS_AS(PixelAllotment(Allotment::bands, {0, 0, 4, 4}, 0, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(PixelAllotment(Allotment::bands, {0, 0, -1, 4}, 1, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(PixelAllotment(Allotment::tiles, {0, 0, 4, 4}, 1, 0, 1), std::invalid_argument);
}

}  // namespace
