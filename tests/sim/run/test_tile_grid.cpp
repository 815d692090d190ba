#include "sim/run/tile_grid.hpp"

#include <random>
#include <vector>

#include "tests/catch.hpp"

using namespace maquette::sim;
using maquette::models::PixelRectangle;

TEST_CASE("every pixel of a zone is in one tile, which the grid finds again") {
  std::mt19937 random(5);
  const auto draw = [&random](int most) { return static_cast<int>(random() % unsigned(most)); };
  for (int round = 0; round < 50; ++round) {
    const TileGrid grid{{draw(100), draw(100), draw(90), draw(90)}};
    std::int64_t pixels = 0;
    for (std::size_t tile = 0; tile < grid.count(); ++tile) {
      const PixelRectangle tile_pixels = grid.rectangle(tile);
      CHECK(tile_pixels.width <= TileGrid::k_tile_pixels);
      CHECK(tile_pixels.height <= TileGrid::k_tile_pixels);
      pixels += tile_pixels.pixels();
      for (int row = tile_pixels.row0; row < tile_pixels.row0 + tile_pixels.height; ++row) {
        for (int column = tile_pixels.column0; column < tile_pixels.column0 + tile_pixels.width;
             ++column) {
          REQUIRE(grid.number_at({column, row}) == tile);
        }
      }
    }
    CHECK(pixels == grid.zone.pixels());
  }
}
