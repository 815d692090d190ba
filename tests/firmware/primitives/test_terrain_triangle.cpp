#include "firmware/primitives/terrain_triangle.hpp"

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/expanded_terrain.hpp"

namespace maquette::firmware::terrain {
namespace {

TEST_CASE("The finest surface stays within the thickness of every coarser triangle") {
  Random random(2004);
  double fullest = 0;
  for (int i = 0; i < 300; ++i) {
    Shape<double> shape = random_land(random, 1 + i % 6).shape;
    shape.roughness = random.uniform(0.1, 1);
    const Land land = land_of(shape);
    const Relief<double> parsed = relief(land.parameters.data());
    const Grid& finest = land.finest();
    for (int level = 0; level < shape.levels; ++level) {
      const Grid& coarse = land.levels[static_cast<std::size_t>(level)];
      double farthest = 0;
      for (int row = 0; row <= finest.cells; ++row) {
        for (int column = 0; column <= finest.cells; ++column) {
          const double coarse_height = coarse.height(static_cast<double>(column) / finest.cells,
                                                     static_cast<double>(row) / finest.cells);
          farthest = std::max(farthest, std::fabs(finest.at(column, row) - coarse_height));
        }
      }
      CAPTURE(i, level);
      REQUIRE(farthest <= parsed.thickness(level));
      fullest = std::max(fullest, farthest / parsed.thickness(level));
    }
    const auto highest = *std::max_element(finest.heights.begin(), finest.heights.end());
    REQUIRE(highest <= parsed.top);
  }
  CHECK(fullest > 0.95);  // the bound is no larger than it need be
}

TEMPLATE_TEST_CASE("A terrain has one height over each point, the same for every number type", "",
                   float, double) {
  using Real = TestType;
  Random random(2005);
  for (int i = 0; i < 60; ++i) {
    const Land land = random_land(random, i % 9);
    const Relief<Real> parsed = relief(parameters_of<Real>(land));
    const int cells = land.finest().cells;
    for (int k = 0; k < 50; ++k) {
      // At vertices, where neighbours must agree; the digits of these are exact.
      const int column = random.below(cells + 1);
      const int row = random.below(cells + 1);
      const Real x = from_integer<Real>(column) / from_integer<Real>(cells);
      const Real y = from_integer<Real>(row) / from_integer<Real>(cells);
      const Triangle<Real> triangle = triangle_at(parsed, x, y);
      const double lazy = static_cast<double>(height(triangle, cell_point(triangle, x, y)));
      CAPTURE(i, k, column, row);
      REQUIRE(std::fabs(lazy - land.finest().at(column, row)) <
              16 * static_cast<double>(ulps<Real>(1)));
    }
  }
}

TEST_CASE("Neighbouring triangles share the heights of their edges bit for bit") {
  Random random(2006);
  for (int i = 0; i < 40; ++i) {
    const Land land = random_land(random, 1 + i % 7);
    const Relief<float> parsed = relief(land.as_float.data());
    const int cells = land.finest().cells;
    for (int k = 0; k < 200; ++k) {
      const int column = random.below(cells);
      const int row = random.below(cells);
      const float cell = 1.0F / static_cast<float>(cells);
      const float x = static_cast<float>(column) * cell;
      const float y = static_cast<float>(row) * cell;
      const Triangle<float> lower = triangle_at(parsed, x + 0.75F * cell, y + 0.25F * cell);
      const Triangle<float> upper = triangle_at(parsed, x + 0.25F * cell, y + 0.75F * cell);
      CAPTURE(i, k, column, row);
      REQUIRE_FALSE(lower.is_above);
      REQUIRE(upper.is_above);
      REQUIRE(lower.first == upper.first);
      REQUIRE(lower.last == upper.last);
      if (column + 1 < cells) {
        const Triangle<float> right = triangle_at(parsed, x + 1.25F * cell, y + 0.75F * cell);
        REQUIRE(lower.corner == right.first);
        REQUIRE(lower.last == right.corner);
      }
      if (row + 1 < cells) {
        const Triangle<float> beyond = triangle_at(parsed, x + 0.75F * cell, y + 1.25F * cell);
        REQUIRE(upper.corner == beyond.first);
        REQUIRE(upper.last == beyond.corner);
      }
    }
  }
}

TEST_CASE("A seed stands for one terrain, whatever levels follow; another seed for another") {
  Random random(2007);
  for (int i = 0; i < 50; ++i) {
    Shape<double> shape = random_land(random, 4).shape;
    const Land land = land_of(shape);
    shape.levels = 7;
    const Land finer = land_of(shape);
    for (int column = 0; column <= 16; ++column) {
      REQUIRE(finer.finest().at(column * 8, 8 * 5) == land.finest().at(column, 5));
    }
    shape.seed = (shape.seed + 1) % k_seed_end;
    const Land other = land_of(shape);
    REQUIRE(std::fabs(other.finest().at(64, 64) - finer.finest().at(64, 64)) > 1e-9);
  }
}

/// How two displacements a step apart go together, in standard deviations of independent ones.
double correlation(int step, int columns, int rows, int seed) {
  constexpr int k_end = 1 << k_level_limit;
  double product = 0;
  double square = 0;
  int count = 0;
  for (int row = 2 * step; row + 2 * step < k_end; row += step) {
    for (int column = 2 * step; column + 2 * step < k_end; column += step) {
      const double here = displacement_of(column, row, k_end, seed);
      product += here * displacement_of(column + columns * step, row + rows * step, k_end, seed);
      square += here * here;
      ++count;
    }
  }
  CHECK(square / count == Approx(1.0 / 3).epsilon(0.1));  // as of a uniform distribution
  return product / square * std::sqrt(count);
}

TEST_CASE("Displacements of neighbours are independent of one another") {
  double sum = 0;
  int count = 0;
  for (const int seed : {0, 1, 2, 1983, k_seed_end - 1}) {
    for (const int step : {4, 8, 16}) {
      for (const auto& [columns, rows] :
           {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 0}, {2, 1}}) {
        const double deviations = correlation(step, columns, rows, seed);
        CAPTURE(seed, step, columns, rows);
        CHECK(std::fabs(deviations) < 4.5);
        sum += deviations * deviations;
        ++count;
      }
    }
  }
  CHECK(std::sqrt(sum / count) == Approx(1).margin(0.2));
}

}  // namespace
}  // namespace maquette::firmware::terrain
