#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/primitives/terrain.hpp"
#include "firmware/primitives/terrain_parameters.hpp"
#include "tests/firmware/primitives/parameters_of.hpp"
#include "tests/firmware/random_cases.hpp"

/// Terrains with all their triangles, made level by level: what those made along a ray must be.
namespace maquette::firmware::terrain {

using trial::Random;

/// Heights of all vertices of a level, row by row.
struct Grid {
  int cells;
  std::vector<double> heights;

  [[nodiscard]] double at(int column, int row) const {
    return heights[static_cast<std::size_t>(row * (cells + 1) + column)];
  }
  /// Height of the surface of triangles; every cell is cut by the diagonal through its origin.
  [[nodiscard]] double height(double x, double y) const {
    const int column = std::clamp(static_cast<int>(std::floor(x * cells)), 0, cells - 1);
    const int row = std::clamp(static_cast<int>(std::floor(y * cells)), 0, cells - 1);
    const double u = x * cells - column;
    const double v = y * cells - row;
    const double first = at(column, row);
    const double last = at(column + 1, row + 1);
    const double corner = u > v ? at(column + 1, row) : at(column, row + 1);
    return first + (corner - first) * std::max(u, v) + (last - corner) * std::min(u, v);
  }
};

inline double displacement_of(int column, int row, int cells, int seed) {
  const auto place = [&](int index) {
    return static_cast<std::uint32_t>(index * ((1 << k_level_limit) / cells));
  };
  const std::uint32_t random = mixed(place(column), place(row), static_cast<std::uint32_t>(seed));
  return static_cast<double>(random >> 8U) / (1 << 23) - 1;
}

/// Cuts all triangles of a grid into four.
inline Grid subdivided(const Grid& grid, double displacement, int seed) {
  const int cells = 2 * grid.cells;
  Grid finer{cells, {}};
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const int left = column / 2;
      const int low = row / 2;
      const int right = left + column % 2;
      const int high = low + row % 2;
      const double middle = (grid.at(left, low) + grid.at(right, high)) / 2;
      const bool is_new = column % 2 != 0 || row % 2 != 0;
      const double share = is_new ? displacement_of(column, row, cells, seed) : 0;
      finer.heights.push_back(middle + displacement * share);
    }
  }
  return finer;
}

/// All levels of a terrain, coarsest first, and the parameters of either number type.
struct Land {
  Shape<double> shape;
  std::vector<Grid> levels;
  std::vector<double> parameters;
  std::vector<float> as_float;

  [[nodiscard]] const Grid& finest() const { return levels.back(); }
};

inline Land land_of(const Shape<double>& shape) {
  Land land{shape, {}, {}, {}};
  const double* c = shape.corners;
  land.levels.push_back({1, {c[0], c[1], c[2], c[3]}});
  double displacement = shape.displacement;
  for (int level = 0; level < shape.levels; ++level) {
    land.levels.push_back(subdivided(land.finest(), displacement, shape.seed));
    displacement *= shape.roughness;
  }
  land.parameters.resize(static_cast<std::size_t>(parameter_count(shape.levels)));
  write_parameters(shape, land.parameters.data());
  land.as_float.assign(land.parameters.begin(), land.parameters.end());
  return land;
}

inline Land random_land(Random& random, int levels) {
  Shape<double> shape{};
  shape.levels = levels;
  shape.seed = random.below(k_seed_end);
  for (double& corner : shape.corners) {
    corner = random.uniform(-0.2, 0.2);
  }
  shape.displacement = random.uniform(0.05, 0.3);
  shape.roughness = random.uniform(0.3, 0.75);
  shape.floor = random.uniform(-0.8, 0);
  return land_of(shape);
}

}  // namespace maquette::firmware::terrain
