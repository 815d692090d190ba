#include "firmware/primitives/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/extent.hpp"
#include "firmware/primitives/cylinder.hpp"
#include "firmware/primitives/generatrix.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::revolution {
namespace {

using trial::Random;

const double k_turn = 2 * std::acos(-1.0);

/// A generatrix of either number type, and as a fine chain of chords in the half-plane.
struct Solid {
  std::vector<double> parameters;
  std::vector<float> as_float;
  std::vector<Vector<double>> chain;  ///< (r, z, 0), closed along the axis
};

void add_chords(Solid& solid) {
  const Generatrix<double> curve = generatrix(solid.parameters.data());
  constexpr int k_chords = 400;
  if (curve.is_open) {
    solid.chain.emplace_back(0, curve.points[1], 0);
  }
  for (int i = 0; i < curve.sections * k_chords; ++i) {
    const double u = static_cast<double>(i % k_chords) / k_chords;
    const CurvePoint<double> point = curve_point(curve.section(i / k_chords), u);
    solid.chain.emplace_back(point.x, point.y, 0);
  }
  if (curve.is_open) {
    const double* end = curve.section(curve.sections);
    solid.chain.emplace_back(end[0], end[1], 0);
    solid.chain.emplace_back(0, end[1], 0);
  }
}

Solid solid_of(const std::vector<double>& control, bool is_open) {
  const int points = static_cast<int>(control.size()) / 2;
  Solid solid;
  solid.parameters.resize(
      static_cast<std::size_t>(parameter_count(section_count(points, is_open))));
  write_parameters(control.data(), points, is_open, solid.parameters.data());
  solid.as_float.assign(solid.parameters.begin(), solid.parameters.end());
  add_chords(solid);
  return solid;
}

template <class Real>
const Real* parameters_of(const Solid& solid);
template <>
const double* parameters_of<double>(const Solid& solid) {
  return solid.parameters.data();
}
template <>
const float* parameters_of<float>(const Solid& solid) {
  return solid.as_float.data();
}

/// A tube around the axis: an outline about a circle in the half-plane, counter-clockwise.
Solid random_ring(Random& random, double roughness) {
  const int points = 3 + random.below(8);
  std::vector<double> control;
  for (int i = 0; i < points; ++i) {
    const double angle = k_turn * i / points;
    const double size = 0.4 * (1 - roughness * random.uniform());
    control.push_back(0.55 + size * std::cos(angle));
    control.push_back(size * std::sin(angle));
  }
  return solid_of(control, false);
}

/// A vase from bottom to top; some touch the axis, some have steps and horizontal parts.
Solid random_vase(Random& random) {
  const int points = 4 + random.below(12);
  std::vector<double> control;
  double z = -1;
  for (int i = 0; i < points; ++i) {
    const bool is_on_axis = random.below(6) == 0;
    control.push_back(is_on_axis ? 0 : random.uniform(0.1, 1));
    control.push_back(z);
    z += random.below(4) == 0 ? 0 : random.uniform(0, 3.0 / points);
  }
  return solid_of(control, true);
}

struct Place {
  bool is_inside;
  double distance;  ///< to the boundary
};

/// By the crossings of the chain with a horizontal line.
Place place_of(const Solid& solid, const Vector<double>& point) {
  const Vector<double> p(std::hypot(point.x, point.y), point.z, 0);
  Place place{false, 1e9};
  for (std::size_t i = 0; i < solid.chain.size(); ++i) {
    const Vector<double>& a = solid.chain[i];
    const Vector<double>& b = solid.chain[(i + 1) % solid.chain.size()];
    const Vector<double> side = b - a;
    const double length_squared = glm::dot(side, side);
    const double along = length_squared > 0 ? glm::dot(p - a, side) / length_squared : 0;
    const double inside = std::fmax(0, std::fmin(1, along));
    if (a.x > 0 || b.x > 0) {
      place.distance = std::fmin(place.distance, glm::length(p - a - side * inside));
    }
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + side.x * (p.y - a.y) / side.y) {
      place.is_inside = !place.is_inside;
    }
  }
  return place;
}

template <class Real>
struct Hits {
  Hit<Real> hits[k_hit_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(const Solid& solid, const Vector<double>& origin,
                   const Vector<double>& direction) {
  Hits<Real> found;
  found.count = intersect<Real>({Vector<Real>(origin), Vector<Real>(direction)},
                                parameters_of<Real>(solid), found.hits);
  return found;
}

/// Random rays towards the solid, many of them special: level or nearly so, along the axis, through
/// it, steep.
Ray<double> random_ray(Random& random, double far) {
  const Vector<double> target = random.in_cube(0.9);
  Vector<double> direction = random.direction();
  switch (random.below(6)) {
    case 0:
      direction.z = 0;
      break;
    case 1:
      direction.z = random.magnitude(1e-12, 1e-1) * (random.coin() ? 1 : -1);
      break;
    case 2:
      direction = {0, 0, direction.z};
      break;
    case 3:
      direction = Vector<double>(target.x, target.y, direction.z);
      break;
    default:
      break;
  }
  direction = glm::normalize(direction);
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

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
