#include "firmware/primitives/terrain.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "firmware/counted.hpp"
#include "firmware/extent.hpp"
#include "firmware/terrain_parameters.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::terrain {
namespace {

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

double displacement_of(int column, int row, int cells, int seed) {
  const auto place = [&](int index) {
    return static_cast<std::uint32_t>(index * ((1 << k_level_limit) / cells));
  };
  const std::uint32_t random = mixed(place(column), place(row), static_cast<std::uint32_t>(seed));
  return static_cast<double>(random >> 8U) / (1 << 23) - 1;
}

/// Cuts all triangles of a grid into four.
Grid subdivided(const Grid& grid, double displacement, int seed) {
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

Land land_of(const Shape<double>& shape) {
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

Land random_land(Random& random, int levels) {
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

template <class Real>
const Real* parameters_of(const Land& land);
template <>
const double* parameters_of<double>(const Land& land) {
  return land.parameters.data();
}
template <>
const float* parameters_of<float>(const Land& land) {
  return land.as_float.data();
}

template <class Real>
struct Hits {
  Hit<Real> hits[k_hit_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(const Land& land, const Vector<double>& origin,
                   const Vector<double>& direction) {
  Hits<Real> found;
  found.count = intersect<Real>({Vector<Real>(origin), Vector<Real>(direction)},
                                parameters_of<Real>(land), found.hits);
  return found;
}

/// Above 0 outside of the solid; below 0 inside.
double outside_by(const Land& land, const Vector<double>& p) {
  const double aside = std::max(std::max(-p.x, p.x - 1), std::max(-p.y, p.y - 1));
  if (aside > 0) {
    return aside;
  }
  return std::max(std::max(aside, land.shape.floor - p.z), p.z - land.finest().height(p.x, p.y));
}

/// Towards a point in the terrain's box; many along lines of the lattice, along diagonals, through
/// vertices, upright, level, grazing.
Ray<double> random_ray(Random& random, const Land& land, double far) {
  const int cells = 1 << random.below(land.shape.levels + 1);
  const auto on_lattice = [&] { return static_cast<double>(random.below(cells + 1)) / cells; };
  Vector<double> target(random.uniform(), random.uniform(), random.uniform(-0.5, 0.5));
  Vector<double> direction = random.direction();
  switch (random.below(9)) {
    case 0:
      target.x = on_lattice();
      direction.x = 0;
      break;
    case 1:
      target.y = on_lattice();
      direction.y = 0;
      break;
    case 2:
      target.y = target.x + on_lattice() * (random.coin() ? 1 : -1);
      direction.y = direction.x;
      break;
    case 3:
      target = {on_lattice(), on_lattice(), target.z};
      break;
    case 4:
      direction = {0, 0, random.coin() ? 1 : -1};
      break;
    case 5:
      target = {on_lattice(), on_lattice(), target.z};
      direction = {0, 0, random.coin() ? 1 : -1};
      break;
    case 6:
      direction.z *= 1e-3;
      break;
    case 7:
      target = {on_lattice(), on_lattice(), 0};
      target.z = land.finest().height(target.x, target.y);
      direction.z *= 0.1;
      break;
    default:
      break;
  }
  direction = glm::normalize(direction);
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

template <class Real>
void check_spans(const Land& land, const Ray<double>& ray, double margin) {
  const Hits<Real> found = hits_on<Real>(land, ray.origin, ray.direction);
  const double step = 0.043 / glm::length(ray.direction);
  trial::check_spans(found.hits, found.count, ray, {0.37 * step, step, 90}, margin,
                     [&](const Vector<double>& p) { return outside_by(land, p); });
}

TEMPLATE_TEST_CASE("The spans of a ray are what lies below the fully expanded surface", "", float,
                   double) {
  Random random(2001);
  // Across a steep surface a rounding of x counts as many times.
  const double margin = 4000 * static_cast<double>(spacings<TestType>(1));
  for (int i = 0; i < 60; ++i) {
    const Land land = random_land(random, i % 8);
    for (int k = 0; k < 60; ++k) {
      CAPTURE(i, k, land.shape.levels, land.shape.seed);
      check_spans<TestType>(land, random_ray(random, land, 2), margin);
    }
  }
}

TEMPLATE_TEST_CASE("No ray, however far its origin, meets a terrain an odd number of times", "",
                   float, double) {
  Random random(2002);
  for (int i = 0; i < 30; ++i) {
    const Land land = random_land(random, i % (k_level_limit + 1));
    for (int k = 0; k < 600; ++k) {
      const Ray<double> ray = random_ray(random, land, random.magnitude(1, 1e8));
      const Hits<TestType> found = hits_on<TestType>(land, ray.origin, ray.direction);
      CAPTURE(i, k, found.count);
      REQUIRE(found.count % 2 == 0);
      for (int j = 1; j < found.count; ++j) {
        REQUIRE(found.hits[j - 1].distance <= found.hits[j].distance);
      }
    }
  }
}

/// A point of a ray and its height above the expanded surface.
struct Sounding {
  double t;
  double above;
};

/// Where a ray that starts in the box crosses the lines of the lattice, in order. In between, its
/// height above the surface has no bend.
std::vector<Sounding> soundings(const Land& land, const Ray<double>& ray) {
  const Grid& grid = land.finest();
  std::vector<double> at{0};
  const auto add_lines = [&](double origin, double direction, int first) {
    for (int i = first; i <= grid.cells; ++i) {
      const double t = (static_cast<double>(i) / grid.cells - origin) / direction;
      const Vector<double> p = ray.origin + ray.direction * t;
      if (t > 0 && std::min(p.x, p.y) > -1e-12 && std::max(p.x, p.y) < 1 + 1e-12) {
        at.push_back(t);
      }
    }
  };
  add_lines(ray.origin.x, ray.direction.x, 0);
  add_lines(ray.origin.y, ray.direction.y, 0);
  add_lines(ray.origin.x - ray.origin.y, ray.direction.x - ray.direction.y, -grid.cells);
  std::sort(at.begin(), at.end());
  std::vector<Sounding> result;
  for (const double t : at) {
    const Vector<double> p = ray.origin + ray.direction * t;
    result.push_back({t, p.z - grid.height(p.x, p.y)});
  }
  return result;
}

/// Distances where it meets the expanded surface.
std::vector<double> expanded_hits(const Land& land, const Ray<double>& ray) {
  const std::vector<Sounding> along = soundings(land, ray);
  std::vector<double> hits;
  for (std::size_t i = 1; i < along.size(); ++i) {
    const Sounding& from = along[i - 1];
    const Sounding& to = along[i];
    if ((from.above < 0) != (to.above < 0)) {
      hits.push_back(from.t + (to.t - from.t) * from.above / (from.above - to.above));
    }
  }
  return hits;
}

TEST_CASE("A terrain made along the ray is the terrain made of all triangles") {
  Random random(2003);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Land land = random_land(random, i % 7);
    for (int k = 0; k < 100; ++k) {
      // Starts inside the box, above the surface.
      const Vector<double> origin(random.uniform(), random.uniform(), land.parameters[3]);
      Vector<double> direction = random.direction();
      direction.z = -std::fabs(direction.z) * random.magnitude(0.05, 1);
      const std::vector<double> expected = expanded_hits(land, {origin, direction});
      const Hits<double> found = hits_on<double>(land, origin, direction);
      std::vector<double> surface;
      for (int j = 0; j < found.count; ++j) {
        if (found.hits[j].face == k_surface) {
          surface.push_back(found.hits[j].distance);
        }
      }
      std::vector<double> above_floor;
      std::copy_if(expected.begin(), expected.end(), std::back_inserter(above_floor),
                   [&](double t) { return origin.z + direction.z * t > land.shape.floor; });
      CAPTURE(i, k, land.shape.levels, land.shape.seed);
      REQUIRE(surface.size() == above_floor.size());
      for (std::size_t j = 0; j < surface.size(); ++j) {
        REQUIRE(surface[j] == Approx(above_floor[j]).margin(1e-9));
        ++hits;
      }
    }
  }
  CHECK(hits > 2000);
}

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
              16 * static_cast<double>(spacings<Real>(1)));
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

/// Volume above the floor of the expanded surface, which must lie above it.
double exact_volume(const Land& land) {
  const Grid& grid = land.finest();
  double sum = 0;
  for (int row = 0; row < grid.cells; ++row) {
    for (int column = 0; column < grid.cells; ++column) {
      const double ends = grid.at(column, row) + grid.at(column + 1, row + 1);
      sum += (2 * ends + grid.at(column + 1, row) + grid.at(column, row + 1)) / 6;
    }
  }
  return sum / grid.cells / grid.cells - land.shape.floor;
}

template <class Real>
double volume_by_chords(const Land& land, const Vector<double>& direction, double cell) {
  const Vector<double> aside = glm::normalize(glm::cross(direction, Vector<double>(0.3, 0.5, 0.8)));
  const Vector<double> up = glm::cross(direction, aside);
  const Vector<double> center(0.5, 0.5, -0.3);
  double sum = 0;
  const int cells = static_cast<int>(3 / cell);
  for (int column = 0; column < cells; ++column) {
    for (int row = 0; row < cells; ++row) {
      const double x = -1.5 + (column + 0.5) * cell;
      const double y = -1.5 + (row + 0.5) * cell;
      const Hits<Real> found =
          hits_on<Real>(land, center + aside * x + up * y - direction * 3.0, direction);
      for (int i = 0; i < found.count; ++i) {
        sum += static_cast<double>(found.hits[i].distance) * (i % 2 == 0 ? -1 : 1);
      }
    }
  }
  return sum * cell * cell;
}

TEMPLATE_TEST_CASE("The volume of all chords is that of the expanded terrain", "", float, double) {
  Random random(2008);
  for (const Vector<double>& direction :
       {Vector<double>(0, 0, -1), Vector<double>(1, 0, 0), glm::normalize(Vector<double>(1, 1, 0)),
        random.direction(), random.direction()}) {
    Shape<double> shape = random_land(random, 5).shape;
    shape.floor = -1.2;  // below all of the surface
    const Land land = land_of(shape);
    CHECK(volume_by_chords<TestType>(land, direction, 0.02) ==
          Approx(exact_volume(land)).epsilon(0.005));
  }
}

TEMPLATE_TEST_CASE("Settled points of a terrain lie on it, with outward normals", "", float,
                   double) {
  using Real = TestType;
  Random random(2009);
  const double near = 4000 * static_cast<double>(spacings<Real>(1));
  int faces = 0;
  for (int i = 0; i < 60; ++i) {
    const Land land = random_land(random, i % 6);
    const Real* parameters = parameters_of<Real>(land);
    Box<Real> box{};
    REQUIRE(bounds(parameters, box));
    for (int k = 0; k < 40; ++k) {
      const Ray<double> ray = random_ray(random, land, 3);
      const Hits<Real> found = hits_on<Real>(land, ray.origin, ray.direction);
      for (int j = 0; j < found.count; ++j) {
        const Hit<Real>& hit = found.hits[j];
        if (hit.distance < Real(0)) {
          continue;
        }
        const Vector<double> p = ray.origin + ray.direction * static_cast<double>(hit.distance);
        const FacePoint<Real> settled = settle(Vector<Real>(p), hit.face, parameters);
        const Vector<double> on(settled.position);
        CAPTURE(i, k, j, static_cast<int>(hit.face), on.x, on.y, on.z);
        REQUIRE(glm::length(on - p) < near);
        REQUIRE(std::fabs(outside_by(land, on)) < near);
        REQUIRE(magnitude(higher(box.low, lower(settled.position, box.high)) - settled.position) <=
                spacings<Real>(4));
        const Vector<double> outward(normalize(settled.normal));
        const Vector<double> away = outward * (4 * near);
        if (hit.face == k_surface) {
          const double cells = land.finest().cells;
          REQUIRE(outward.z > 0);
          // Where neither a fold of the surface nor its border is near.
          const double u = on.x * cells - std::floor(on.x * cells);
          const double v = on.y * cells - std::floor(on.y * cells);
          const double from_fold = std::min({u, v, 1 - u, 1 - v, std::fabs(u - v) / 2}) / cells;
          if (from_fold > glm::length(away)) {
            ++faces;
            REQUIRE(outside_by(land, on + away) > 0);
            REQUIRE(outside_by(land, on - away) < 0);
            REQUIRE(land.finest().height(on.x + away.x, on.y + away.y) ==
                    Approx(on.z - (away.x * away.x + away.y * away.y) / away.z));
          }
        } else {
          REQUIRE(outside_by(land, on + away) > 0);
        }
      }
    }
  }
  CHECK(faces > 500);
}

TEMPLATE_TEST_CASE("A ray that leaves a plane terrain does not meet it again", "", float, double) {
  using Real = TestType;
  Random random(2010);
  Shape<double> shape{};
  shape.levels = 6;
  shape.floor = -0.9;
  shape.corners[1] = shape.corners[2] = 0.3;
  shape.corners[3] = 0.6;
  const Land land = land_of(shape);
  const Real* parameters = parameters_of<Real>(land);
  for (int i = 0; i < 20000; ++i) {
    const Vector<Real> p(Vector<double>(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), 0));
    const FacePoint<Real> settled = settle(p, k_surface, parameters);
    const Vector<Real> outward = normalize(settled.normal);
    const Vector<Real> start = settled.position + outward * spacings<Real>(16);
    const Vector<double> away =
        random.direction_around(glm::normalize(Vector<double>(outward)), random.magnitude(1e-6, 1));
    const Hits<Real> again = hits_on<Real>(land, Vector<double>(start), away);
    CAPTURE(i, start.x, start.y);
    REQUIRE(again.count == 0);
  }
}

/// Whether a ray from a point of the expanded surface rises from it and does not come near it
/// again.
bool is_free(const Land& land, const Ray<double>& ray) {
  const std::vector<Sounding> along = soundings(land, ray);
  return std::all_of(along.begin() + 1, along.end(),
                     [](const Sounding& point) { return point.above > 1e-3 * point.t; });
}

TEMPLATE_TEST_CASE("A free ray from any point of a rough terrain, also from its folds, is free", "",
                   float, double) {
  using Real = TestType;
  Random random(2011);
  int free_rays = 0;
  int folds = 0;
  for (int i = 0; i < 40; ++i) {
    const Land land = random_land(random, 5);
    const Real* parameters = parameters_of<Real>(land);
    for (int k = 0; k < 200; ++k) {
      Vector<double> place(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), 0);
      if (random.coin()) {
        // Within the clearance of a fold.
        ++folds;
        place.x = (1 + random.below(30)) / 32.0 + random.uniform(-8, 8) * 1e-7;
      }
      const FacePoint<Real> settled = settle(Vector<Real>(place), k_surface, parameters);
      const Vector<Real> outward = normalize(settled.normal);
      const Vector<Real> start = settled.position + outward * spacings<Real>(32);
      const Vector<double> away =
          random.direction_around(glm::normalize(Vector<double>(outward)), random.uniform(0.1, 1));
      const Vector<double> on(place.x, place.y, land.finest().height(place.x, place.y));
      if (!is_free(land, {on, away})) {
        continue;
      }
      ++free_rays;
      const Hits<Real> again = hits_on<Real>(land, Vector<double>(start), away);
      CAPTURE(i, k, start.x, start.y, start.z, away.x, away.y, away.z);
      REQUIRE(again.count == 0);
    }
  }
  CHECK(free_rays > 2000);
}

TEST_CASE("Counted and float terrains are the same, and what is skipped costs nothing") {
  Random random(2012);
  const Land land = random_land(random, 8);
  const std::vector<Counted> parameters(land.as_float.begin(), land.as_float.end());
  for (int i = 0; i < 500; ++i) {
    const Ray<double> ray = random_ray(random, land, 3);
    const Hits<float> plain = hits_on<float>(land, ray.origin, ray.direction);
    Hits<Counted> counted;
    const Vector<float> origin(ray.origin);
    const Vector<float> direction(ray.direction);
    counted.count = intersect<Counted>(
        {{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}},
        parameters.data(), counted.hits);
    REQUIRE(counted.count == plain.count);
    for (int k = 0; k < plain.count; ++k) {
      REQUIRE(counted.hits[k].distance.value == plain.hits[k].distance);
      REQUIRE(counted.hits[k].face == plain.hits[k].face);
    }
  }
  // High above its mountains a ray makes no triangle.
  Hit<Counted> hits[k_hit_limit];
  reset_counted_work();
  const float above = land.as_float[3] * 1.01F;
  intersect<Counted>({{0, 0, above}, {1, 1, 0}}, parameters.data(), hits);
  CHECK(counted_work()[Operation::integer_to_float] == 0);
}

TEST_CASE("A ray that meets more hills than there is room for ends behind one of them") {
  Shape<double> shape{};
  shape.levels = 10;
  shape.seed = 5;
  shape.displacement = 0.01;
  shape.roughness = 1;
  shape.floor = -0.5;
  const Land land = land_of(shape);
  Random random(2013);
  int full = 0;
  for (int i = 0; i < 200; ++i) {
    const double y = random.uniform();
    const Hits<double> found = hits_on<double>(land, {-1, y, 0}, {1, 0.0001, 0});
    REQUIRE(found.count % 2 == 0);
    full += found.count == k_hit_limit ? 1 : 0;
    for (int k = 0; k + 1 < found.count; k += 2) {
      const double middle = (found.hits[k].distance + found.hits[k + 1].distance) / 2;
      CAPTURE(i, k);
      REQUIRE(found.hits[k].distance <= found.hits[k + 1].distance);
      if (found.hits[k + 1].distance - found.hits[k].distance < 0.5 / 1024) {
        REQUIRE(outside_by(land, {middle - 1, y + 0.0001 * middle, 0}) < 1e-12);
      }
    }
  }
  CHECK(full > 100);
}

}  // namespace
}  // namespace maquette::firmware::terrain
