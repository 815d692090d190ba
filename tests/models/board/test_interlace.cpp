#include "models/board/interlace.hpp"

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using traffic::below;

AllotmentParameters interlaced(std::optional<int> columns, std::optional<int> lines) {
  AllotmentParameters parameters;
  parameters.order = Allotment::interlaced;
  parameters.columns = columns;
  parameters.lines = lines;
  return parameters;
}

Interlace random_interlace(std::mt19937& generator) {
  return {1 + below(generator, 9), 1 + below(generator, 9)};
}

PixelRectangle random_zone(std::mt19937& generator) {
  return {below(generator, 50), below(generator, 50), below(generator, 40), below(generator, 40)};
}

}  // namespace

TEST_CASE("an interlace has as many pixels as boards, as near to a square as it can be") {
  for (int boards = 1; boards <= 256; ++boards) {
    const Interlace interlace = interlace_of(interlaced({}, {}), boards);
    REQUIRE(interlace.columns * interlace.lines == boards);
    REQUIRE(interlace.columns >= interlace.lines);
    for (int columns = 1; columns <= boards; ++columns) {
      if (boards % columns == 0) {
        const Interlace other = interlace_of(interlaced(columns, {}), boards);
        REQUIRE(other.columns == columns);
        REQUIRE(other.lines == boards / columns);
        REQUIRE(interlace_of(interlaced({}, columns), boards).columns == boards / columns);
        REQUIRE(std::max(interlace.columns, interlace.lines) <=
                std::max(other.columns, other.lines));
      } else {
        REQUIRE_THROWS_AS(interlace_of(interlaced(columns, {}), boards), std::invalid_argument);
        REQUIRE_THROWS_AS(interlace_of(interlaced({}, columns), boards), std::invalid_argument);
      }
    }
  }
  CHECK_THROWS_AS(interlace_of(interlaced(2, 3), 5), std::invalid_argument);
  CHECK_THROWS_AS(interlace_of(interlaced(0, {}), 5), std::invalid_argument);
  CHECK_THROWS_AS(interlace_of(interlaced({}, -1), 5), std::invalid_argument);
}

TEST_CASE("of as many pixels side by side as there are boards each is another board's") {
  std::mt19937 generator(1984);
  for (int one = 0; one < 100; ++one) {
    const Interlace interlace = random_interlace(generator);
    const PixelPosition corner{below(generator, 700), below(generator, 500)};
    std::set<int> boards;
    for (int row = 0; row < interlace.lines; ++row) {
      for (int column = 0; column < interlace.columns; ++column) {
        const int board = interlace.board_of({corner.column + column, corner.row + row});
        REQUIRE(board >= 0);
        REQUIRE(board < interlace.columns * interlace.lines);
        REQUIRE(boards.insert(board).second);
      }
    }
  }
}

TEST_CASE("a unit of an interlace has its board's pixels and no others, row by row") {
  std::mt19937 generator(1979);
  for (int one = 0; one < 300; ++one) {
    const Interlace interlace = random_interlace(generator);
    const PixelRectangle zone = random_zone(generator);
    const InterlacedPixels pixels(interlace, zone);
    REQUIRE(pixels.units() == interlace.columns * interlace.lines);
    REQUIRE(pixels.first_pixel(0) == 0);
    REQUIRE(pixels.first_pixel(pixels.units()) == zone.pixels());
    std::set<std::pair<int, int>> seen;
    for (std::int64_t unit = 0; unit < pixels.units(); ++unit) {
      std::pair<int, int> before{-1, -1};
      for (std::int64_t index = pixels.first_pixel(unit); index < pixels.first_pixel(unit + 1);
           ++index) {
        const PixelPosition position = pixels.position(index);
        REQUIRE(interlace.board_of(position) == unit);
        REQUIRE(pixels.index(position) == index);
        REQUIRE((position.column >= zone.column0 && position.column < zone.column0 + zone.width));
        REQUIRE((position.row >= zone.row0 && position.row < zone.row0 + zone.height));
        REQUIRE(before < std::pair(position.row, position.column));
        before = {position.row, position.column};
        REQUIRE(seen.insert(before).second);
      }
    }
    REQUIRE(static_cast<std::int64_t>(seen.size()) == zone.pixels());
  }
}

TEST_CASE("an index that no pixel of the zone has is refused") {
  std::mt19937 generator(5);
  for (int round = 0; round < 200; ++round) {
    const Interlace interlace = random_interlace(generator);
    const PixelRectangle zone = random_zone(generator);
    const InterlacedPixels pixels(interlace, zone);
    CHECK_THROWS_AS(pixels.position(-1), std::out_of_range);
    CHECK_THROWS_AS(pixels.position(zone.pixels()), std::out_of_range);
    CHECK_THROWS_AS(pixels.position(zone.pixels() + 1000), std::out_of_range);
  }
}

TEST_CASE("boards of an interlace have as many pixels, give or take one per row and column") {
  std::mt19937 generator(1977);
  for (int one = 0; one < 300; ++one) {
    const Interlace interlace = random_interlace(generator);
    const PixelRectangle zone = random_zone(generator);
    const InterlacedPixels pixels(interlace, zone);
    const std::int64_t least =
        std::int64_t{zone.width / interlace.columns} * (zone.height / interlace.lines);
    const std::int64_t most =
        std::int64_t{(zone.width + interlace.columns - 1) / interlace.columns} *
        ((zone.height + interlace.lines - 1) / interlace.lines);
    for (std::int64_t unit = 0; unit < pixels.units(); ++unit) {
      const std::int64_t count = pixels.first_pixel(unit + 1) - pixels.first_pixel(unit);
      REQUIRE((count >= least && count <= most));
    }
  }
}
