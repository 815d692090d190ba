#include "firmware/primitives/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/extent.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/expanded_terrain.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::terrain {
namespace {

using trial::Random;

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
  const double margin = 4000 * static_cast<double>(ulps<TestType>(1));
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
  const double near = 4000 * static_cast<double>(ulps<Real>(1));
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
                ulps<Real>(4));
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
    const Vector<Real> start = settled.position + outward * ulps<Real>(16);
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
      const Vector<Real> start = settled.position + outward * ulps<Real>(32);
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
