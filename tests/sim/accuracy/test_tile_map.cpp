#include "sim/accuracy/tile_map.hpp"

#include "tests/catch.hpp"
#include "tests/sim/accuracy/random_ladders.hpp"

using namespace maquette::sim;

TEST_CASE("the map is red where a level takes longer, blue where shorter, the worst in full") {
  TileError error;
  error.grid = {{10, 20, 64, 16}};
  error.relative = {0.0, 0.5, -0.25, std::nullopt};
  error.worst = 0.5;
  const maquette::models::Picture map = tile_map(error, 100, 50);
  REQUIRE(map.pixels.size() == 5000);
  CHECK(map.at(10, 20) == 0xFFFFFF);
  CHECK(map.at(26, 20) == 0xFF0000);
  CHECK(map.at(42 + 15, 35) == 0x7F7FFF);
  const std::uint32_t left_out = map.at(60, 30);
  const std::uint32_t outside = map.at(0, 0);
  CHECK(left_out != outside);
  for (const auto& [column, row] : {std::pair(9, 20), {10, 19}, {74, 20}, {10, 36}, {99, 49}}) {
    CHECK(map.at(column, row) == outside);
  }
}

TEST_CASE("a level without any error is white") {
  TileError error;
  error.grid = {{0, 0, 16, 16}};
  error.relative = {0.0};
  for (const std::uint32_t pixel : tile_map(error, 16, 16).pixels) {
    CHECK(pixel == 0xFFFFFF);
  }
}

TEST_CASE("what is mapped is never the reference, and nothing without tiles") {
  std::mt19937 random(41);
  LadderResult result =
      maquette::tests::random_ladder(random, maquette::sim::ErrorMeasure::frame_time);
  const std::optional<TileError> mapped = mapped_error({result});
  REQUIRE(mapped.has_value());
  CHECK(mapped->worst > 0);
  for (LevelResult& level : result.levels) {
    level.error.tiles.reset();
  }
  CHECK_FALSE(mapped_error({result}).has_value());
}
