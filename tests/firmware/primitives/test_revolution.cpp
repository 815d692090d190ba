#include "firmware/primitives/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/extent.hpp"
#include "firmware/primitives/cylinder.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/revolution_solids.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::revolution {
namespace {

using namespace trial;

template <class Real>
void check_spans(const Solid& solid, const Ray<double>& ray, double margin) {
  const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
  trial::check_spans(found.hits, found.count, ray, trial::samples_around(ray, 14, 0.11), margin,
                     [&](const Vector<double>& p) {
                       const Place place = place_of(solid, p);
                       return place.is_inside ? -place.distance : place.distance;
                     });
}

TEMPLATE_TEST_CASE("The spans of a ray are what lies inside the generatrix", "", float, double) {
  Random random(1801);
  for (int i = 0; i < 40; ++i) {
    const Solid solid = random.coin() ? random_vase(random) : random_ring(random, 0.8);
    for (int k = 0; k < 12; ++k) {
      CAPTURE(i, k);
      check_spans<TestType>(solid, random_ray(random, 4), 2e-4);
    }
  }
}

TEMPLATE_TEST_CASE("No ray, however far its origin, meets a solid an odd number of times", "",
                   float, double) {
  Random random(1802);
  for (int i = 0; i < 200; ++i) {
    const Solid solid = random.coin() ? random_vase(random) : random_ring(random, 0.8);
    for (int k = 0; k < 400; ++k) {
      const Ray<double> ray = random_ray(random, random.magnitude(1, 1e8));
      CAPTURE(i, k);
      REQUIRE(hits_on<TestType>(solid, ray.origin, ray.direction).count % 2 == 0);
    }
  }
}

/// Control points (r, z) of a straight line from (r, z) = (from, -1) to (to, 1).
std::vector<double> straight(double from, double to, int sections) {
  std::vector<double> control;
  for (int i = -1; i <= sections + 1; ++i) {
    const double share = static_cast<double>(i) / sections;
    control.push_back(from + (to - from) * share);
    control.push_back(-1 + 2 * share);
  }
  return control;
}

/// Distance from the axis to a line.
double passing(const Ray<double>& ray) {
  const Vector<double> normal(ray.direction.y, -ray.direction.x, 0);
  const double across = glm::length(normal);
  return across > 0 ? std::fabs(glm::dot(ray.origin, normal)) / across
                    : std::hypot(ray.origin.x, ray.origin.y);
}

TEMPLATE_TEST_CASE("A straight generatrix parallel to the axis is a cylinder", "", float, double) {
  Random random(1803);
  const double tolerance = 200 * static_cast<double>(ulps<TestType>(1));
  for (int sections = 1; sections <= 7; ++sections) {
    const Solid solid = solid_of(straight(1, 1, sections), true);
    for (int i = 0; i < 2000; ++i) {
      const Ray<double> ray = random_ray(random, 4);
      if (passing(ray) > 0.9) {
        continue;  // there a rounded ray may pass the other side of an edge
      }
      Hit<double> expected[2];
      const int count = cylinder::intersect<double>(ray, nullptr, expected);
      const Hits<TestType> found = hits_on<TestType>(solid, ray.origin, ray.direction);
      CAPTURE(sections, i, ray.direction.z);
      REQUIRE(found.count == count);
      for (int k = 0; k < count; ++k) {
        const double apart = static_cast<double>(found.hits[k].distance) - expected[k].distance;
        REQUIRE(std::fabs(apart) * glm::length(ray.direction) < tolerance);
      }
    }
  }
}

/// Volume by Pappus and Green: pi times the integral of r^2 dz over the boundary.
double exact_volume(const Solid& solid) {
  double sum = 0;
  for (std::size_t i = 0; i < solid.chain.size(); ++i) {
    const Vector<double>& a = solid.chain[i];
    const Vector<double>& b = solid.chain[(i + 1) % solid.chain.size()];
    sum += (a.x * a.x + a.x * b.x + b.x * b.x) / 3 * (b.y - a.y);
  }
  return k_turn / 2 * sum;
}

/// Volume by the chords of parallel rays through a grid of cells of area `cell * cell`.
template <class Real>
double volume_by_chords(const Solid& solid, const Vector<double>& direction, double cell) {
  const Vector<double> aside = glm::normalize(glm::cross(direction, Vector<double>(0.3, 0.5, 0.8)));
  const Vector<double> up = glm::cross(direction, aside);
  double sum = 0;
  const int cells = static_cast<int>(4 / cell);
  for (int column = 0; column < cells; ++column) {
    for (int row = 0; row < cells; ++row) {
      const double x = -2 + (column + 0.5) * cell;
      const double y = -2 + (row + 0.5) * cell;
      const Hits<Real> found =
          hits_on<Real>(solid, aside * x + up * y - direction * 3.0, direction);
      for (int i = 0; i < found.count; ++i) {
        sum += static_cast<double>(found.hits[i].distance) * (i % 2 == 0 ? -1 : 1);
      }
    }
  }
  return sum * cell * cell;
}

TEMPLATE_TEST_CASE("The volume of all chords is that of the solid", "", float, double) {
  Random random(1804);
  const Vector<double> directions[] = {{0, 0, 1}, {1, 0, 0}, random.direction()};
  for (const Vector<double>& direction : directions) {
    const Solid ring = random_ring(random, 0.3);
    CHECK(volume_by_chords<TestType>(ring, direction, 0.02) ==
          Approx(exact_volume(ring)).epsilon(0.005));
    const Solid vase = random_vase(random);
    CHECK(volume_by_chords<TestType>(vase, direction, 0.02) ==
          Approx(exact_volume(vase)).epsilon(0.005));
  }
}

TEMPLATE_TEST_CASE("Settled points lie on the surface, within its bounds, with outward normals", "",
                   float, double) {
  using Real = TestType;
  Random random(1805);
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const Solid solid = random.coin() ? random_vase(random) : random_ring(random, 0.3);
    const Real* parameters = parameters_of<Real>(solid);
    Box<Real> box{};
    REQUIRE(bounds(parameters, box));
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray = random_ray(random, 4);
      const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
      for (int j = 0; j < found.count; ++j) {
        const Hit<Real>& hit = found.hits[j];
        const Vector<double> p = ray.origin + ray.direction * static_cast<double>(hit.distance);
        const FacePoint<Real> settled = settle(Vector<Real>(p), hit.face, parameters);
        const Vector<double> on(settled.position);
        CAPTURE(i, k, j, static_cast<int>(hit.face), on.x, on.y, on.z);
        REQUIRE(place_of(solid, on).distance < 1e-5);
        REQUIRE(magnitude(higher(box.low, lower(settled.position, box.high)) - settled.position) <=
                ulps<Real>(4));
        const Vector<Real>& outward = settled.normal;
        REQUIRE(length(outward) > Real(0));
        const double step = 1e-3;
        const Vector<double> away = glm::normalize(Vector<double>(outward)) * step;
        const Place beyond = place_of(solid, on + away);
        const Place within = place_of(solid, on - away);
        // Not at edges, where another part of the surface is near and on folds without thickness.
        if (beyond.distance > 0.9 * step && within.distance > 0.9 * step &&
            beyond.is_inside != within.is_inside) {
          ++checked;
          REQUIRE(within.is_inside);
        }
      }
    }
  }
  CHECK(checked > 1000);
}

TEMPLATE_TEST_CASE("A ray that leaves a convex solid does not meet it again", "", float, double) {
  using Real = TestType;
  Random random(1806);
  const Solid barrel =
      solid_of({0.4, -1.2, 0.7, -0.8, 0.9, -0.4, 1, 0, 0.9, 0.4, 0.7, 0.8, 0.4, 1.2}, true);
  const Real* parameters = parameters_of<Real>(barrel);
  for (int i = 0; i < 20000; ++i) {
    const Vector<double> target = random.in_cube(0.6);
    const Vector<double> direction = random.direction();
    const Hits<Real> found = hits_on<Real>(barrel, target - direction * 3.0, direction);
    if (found.count == 0) {
      continue;
    }
    const Vector<Real> p =
        Vector<Real>(target - direction * 3.0) + Vector<Real>(direction) * found.hits[0].distance;
    const FacePoint<Real> settled = settle(p, found.hits[0].face, parameters);
    const Vector<Real> outward = normalize(settled.normal);
    const Vector<Real> start = settled.position + outward * ulps<Real>(32);
    const Vector<double> axis(outward);
    const Vector<double> away =
        random.direction_around(glm::normalize(axis), random.magnitude(1e-6, 1));
    const Hits<Real> again = hits_on<Real>(barrel, Vector<double>(start), away);
    for (int k = 0; k < again.count; ++k) {
      CAPTURE(i, k, glm::dot(axis, away));
      REQUIRE(again.hits[k].distance <= ulps<Real>(64));
    }
  }
}

TEST_CASE("A normal exists on the axis and where the generatrix is horizontal") {
  // A spline through the axis at its start, level there, and with a flat shoulder.
  const Solid dome = solid_of({0.3,  -1,  0, -1,  0.3, -1,  0.6, -1,  0.9, -1,  0.9,
                               -0.5, 0.8, 0, 0.5, 0,   0.2, 0,   0.2, 0.5, 0.2, 1},
                              true);
  for (int face = 0; face < 8; ++face) {
    for (int i = 0; i <= 16; ++i) {
      for (int k = -16; k <= 16; ++k) {
        const auto section = static_cast<std::uint8_t>(face);
        const double* parameters = dome.parameters.data();
        const Vector<double> outward =
            settle<double>({i / 16.0, 0, k / 16.0}, section, parameters).normal;
        REQUIRE(glm::length(outward) > 0);
        REQUIRE(outward.y == 0);
      }
    }
  }
}

}  // namespace
}  // namespace maquette::firmware::revolution
