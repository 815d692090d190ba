#include "sim/accuracy/tile_error.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.hpp"

using namespace maquette::sim;
using maquette::models::Duration;

namespace {

TileTimes random_times(std::mt19937& random) {
  TileTimes tiles{{{3, 5, 150, 90}}, {}};
  while (tiles.times.size() < tiles.grid.count()) {
    tiles.times.emplace_back(random() % 8 == 0 ? 0 : 1'000'000 + random() % 1'000'000);
  }
  return tiles;
}

}  // namespace

TEST_CASE("a level has no error against itself, and that of a factor against its multiple") {
  std::mt19937 random(31);
  const TileTimes reference = random_times(random);
  const TileError none = tile_error(reference, reference);
  CHECK(none.median == 0);
  CHECK(none.worst == 0);
  TileTimes shorter = reference;
  for (Duration& time : shorter.times) {
    time = time * 3 / 4;
  }
  const TileError quarter = tile_error(shorter, reference);
  CHECK(quarter.median == Approx(0.25).epsilon(1e-5));
  CHECK(quarter.most_of_95 == Approx(0.25).epsilon(1e-5));
  CHECK(quarter.worst == Approx(0.25).epsilon(1e-5));
}

TEST_CASE(
    "errors are of the tiles that both have timed, with their sign, the worst is the largest") {
  std::mt19937 random(32);
  for (int round = 0; round < 100; ++round) {
    const TileTimes reference = random_times(random);
    const TileTimes tiles = random_times(random);
    const TileError error = tile_error(tiles, reference);
    REQUIRE(error.relative.size() == tiles.grid.count());
    double worst = 0;
    int above_median = 0;
    int timed = 0;
    for (std::size_t tile = 0; tile < tiles.times.size(); ++tile) {
      const auto time = static_cast<double>(tiles.times[tile].count());
      const auto reference_time = static_cast<double>(reference.times[tile].count());
      REQUIRE(error.relative[tile].has_value() == (time > 0 && reference_time > 0));
      if (error.relative[tile]) {
        CHECK(reference_time * (1 + *error.relative[tile]) == Approx(time));
        worst = std::max(worst, std::abs(*error.relative[tile]));
        above_median += std::abs(*error.relative[tile]) > error.median ? 1 : 0;
        ++timed;
      }
    }
    CHECK(error.worst == worst);
    CHECK(above_median == timed / 2);
    CHECK(error.median <= error.most_of_95);
    CHECK(error.most_of_95 <= error.worst);
  }
}
