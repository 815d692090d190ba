#include "firmware/primitives/algebraic.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/extent.hpp"
#include "firmware/primitives/cylinder.hpp"
#include "firmware/primitives/sphere.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/algebraic_solids.hpp"
#include "tests/firmware/primitives/span_laws.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::algebraic {
namespace {

using trial::Random;

const double k_half_turn = std::acos(-1.0);

/// The torus about z: (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2).
Solid torus(double large, double small) {
  const double rest = large * large - small * small;
  const double flat = 2 * rest - 4 * large * large;
  return solid_of({{4, 0, 0, 1},
                   {0, 4, 0, 1},
                   {0, 0, 4, 1},
                   {2, 2, 0, 2},
                   {2, 0, 2, 2},
                   {0, 2, 2, 2},
                   {2, 0, 0, flat},
                   {0, 2, 0, flat},
                   {0, 0, 2, 2 * rest},
                   {0, 0, 0, rest * rest}});
}

/// x^n + y^n + z^n = size^n, convex for an even n.
Solid superquadric(int degree, double size) {
  return solid_of({{degree, 0, 0, 1},
                   {0, degree, 0, 1},
                   {0, 0, degree, 1},
                   {0, 0, 0, -std::pow(size, degree)}});
}

template <class Real>
struct Hits {
  Hit<Real> hits[k_degree_limit + 2];
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

/// Random rays towards the cube, some along its axes, in its planes or through its centre.
Ray<double> random_ray(Random& random, double far) {
  Vector<double> target = random.in_cube(0.98);
  Vector<double> direction = random.direction();
  const int axis = random.below(3);
  switch (random.below(7)) {
    case 0:
      direction[axis] = 0;
      break;
    case 1:
      direction = {0, 0, 0};
      direction[axis] = random.coin() ? 1 : -1;
      break;
    case 2:
      target = {0, 0, 0};
      break;
    case 3:
      direction[axis] = 0;
      target[axis] = random.below(3) - 1;
      break;
    default:
      break;
  }
  direction = glm::normalize(direction);
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

/// Whether a point is inside, and how far f and the cube's planes are from changing that.
struct Place {
  bool is_inside;
  double margin;
};

Place place_of(const Solid& solid, const Vector<double>& p) {
  const double value = value_at(solid, p);
  const double beyond = magnitude(p) - 1;
  return {value < 0 && beyond < 0, std::fmin(std::fabs(value), std::fabs(beyond))};
}

template <class Real>
void check_spans(const Solid& solid, const Ray<double>& ray, double margin) {
  const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
  REQUIRE(found.count <= hit_limit(parameters_of<Real>(solid)));
  trial::check_spans(found.hits, found.count, ray, trial::samples_around(ray, 20, 0.09), margin,
                     [&](const Vector<double>& p) {
                       const Place place = place_of(solid, p);
                       return place.is_inside ? -place.margin : place.margin;
                     });
}

TEMPLATE_TEST_CASE("The spans of a ray are where the polynomial is negative in the cube", "", float,
                   double) {
  Random random(2103);
  const double margin = 1000 * static_cast<double>(ulps<TestType>(1));
  for (int i = 0; i < 300; ++i) {
    const Solid solid = random_solid(random);
    for (int k = 0; k < 12; ++k) {
      CAPTURE(i, k);
      check_spans<TestType>(solid, random_ray(random, 4), margin);
    }
  }
}

TEMPLATE_TEST_CASE("No ray, however far its origin, meets a solid an odd number of times", "",
                   float, double) {
  Random random(2104);
  const Solid double_cone = solid_of({{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, -1}});
  const Solid folded = solid_of({{2, 0, 0, 1}, {0, 2, 1, -1}});
  const Solid squared = solid_of({{4, 0, 0, 1}, {2, 0, 0, -0.5}, {0, 0, 0, 0.0625}});
  for (int i = 0; i < 200; ++i) {
    const Solid solids[] = {random_solid(random), torus(0.6, 0.35), double_cone, folded, squared};
    for (const Solid& solid : solids) {
      for (int k = 0; k < 100; ++k) {
        const Ray<double> ray = random_ray(random, random.magnitude(1, 1e8));
        CAPTURE(i, k);
        const int count = hits_on<TestType>(solid, ray.origin, ray.direction).count;
        REQUIRE(count % 2 == 0);
        REQUIRE(count <= hit_limit(parameters_of<TestType>(solid)));
      }
    }
  }
}

TEMPLATE_TEST_CASE("Quadrics given by coefficients are the sphere and the cylinder", "", float,
                   double) {
  using Real = TestType;
  Random random(2105);
  const double tolerance = 200 * static_cast<double>(ulps<Real>(1));
  const Solid ball = superquadric(2, 1);
  const Solid tube = solid_of({{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 0, -1}});
  for (int i = 0; i < 5000; ++i) {
    const Ray<double> ray = random_ray(random, 4);
    const Solid& solid = random.coin() ? ball : tube;
    Hit<double> expected[2];
    const int count = &solid == &ball ? sphere::intersect<double>(ray, nullptr, expected)
                                      : cylinder::intersect<double>(ray, nullptr, expected);
    const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
    const double speed = glm::length(ray.direction);
    if (count == 2 && (expected[1].distance - expected[0].distance) * speed < 0.1) {
      continue;  // rounding moves where a ray grazes, and may take it past an edge
    }
    CAPTURE(i, count, found.count);
    if (count == 0) {
      REQUIRE((found.count == 0 ||
               static_cast<double>(found.hits[1].distance - found.hits[0].distance) < 0.01));
      continue;
    }
    REQUIRE(found.count == 2);
    for (int k = 0; k < 2; ++k) {
      const double apart = static_cast<double>(found.hits[k].distance) - expected[k].distance;
      REQUIRE(std::fabs(apart) * speed < tolerance);
    }
  }
}

TEST_CASE("Floats find every hit of doubles at which the ray does not graze") {
  Random random(2109);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const Solid solid =
        random.coin() ? random_solid(random) : torus(0.6, random.uniform(0.01, 0.4));
    for (int k = 0; k < 20; ++k) {
      Ray<double> ray = random_ray(random, 4);
      ray.origin = Vector<double>(Vector<float>(ray.origin));
      ray.direction = Vector<double>(Vector<float>(ray.direction));
      const Hits<double> exact = hits_on<double>(solid, ray.origin, ray.direction);
      const Hits<float> found = hits_on<float>(solid, ray.origin, ray.direction);
      for (int j = 0; j < exact.count; ++j) {
        const double t = exact.hits[j].distance;
        const Vector<double> p = ray.origin + ray.direction * t;
        const double change = std::fabs(glm::dot(gradient_at(solid, p), ray.direction));
        const double tolerance = 2e-5 / change;
        if (exact.hits[j].face != k_surface || tolerance > 1e-3 || magnitude(p) > 1 - tolerance) {
          continue;
        }
        ++checked;
        CAPTURE(i, k, j, t, change);
        REQUIRE(std::any_of(found.hits, found.hits + found.count, [&](const Hit<float>& hit) {
          return std::fabs(static_cast<double>(hit.distance) - t) < tolerance;
        }));
      }
    }
  }
  CHECK(checked > 2000);
}

struct Measure {
  double volume;
  double area;
};

/// From the chords of parallel rays through a grid, over directions spread evenly (a spiral of
/// equal areas): the volume is theirs, the area twice the mean of the crossings' cells (Crofton).
template <class Real>
Measure measure_by_chords(const Solid& solid, Random& random) {
  const double cell = 0.05;
  const int cells = static_cast<int>(4 / cell);
  const int directions = 40;
  Measure measure{0, 0};
  for (int i = 0; i < directions; ++i) {
    const double height = (2 * i + 1.0) / directions - 1;
    const double turn = i * k_half_turn * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - height * height);
    const Vector<double> direction(radius * std::cos(turn), radius * std::sin(turn), height);
    const Vector<double> aside = glm::normalize(glm::cross(direction, random.direction()));
    const Vector<double> up = glm::cross(direction, aside);
    for (int place = 0; place < cells * cells; ++place) {
      const double x = -2 + (place % cells + random.uniform()) * cell;
      const double y = -2 + (place / cells + random.uniform()) * cell;
      const Hits<Real> found =
          hits_on<Real>(solid, aside * x + up * y - direction * 3.0, direction);
      measure.area += 2.0 * found.count;
      for (int k = 0; k < found.count; ++k) {
        measure.volume += static_cast<double>(found.hits[k].distance) * (k % 2 == 0 ? -1 : 1);
      }
    }
  }
  const double share = cell * cell / directions;
  return {measure.volume * share, measure.area * share};
}

TEMPLATE_TEST_CASE("Chords give the volume and the area of a torus and of a clipped cylinder", "",
                   float, double) {
  Random random(2106);
  const Measure ring = measure_by_chords<TestType>(torus(0.6, 0.35), random);
  CHECK(ring.volume == Approx(2 * k_half_turn * k_half_turn * 0.6 * 0.35 * 0.35).epsilon(0.005));
  CHECK(ring.area == Approx(4 * k_half_turn * k_half_turn * 0.6 * 0.35).epsilon(0.01));
  const Measure tube =
      measure_by_chords<TestType>(solid_of({{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 0, -0.49}}), random);
  CHECK(tube.volume == Approx(2 * k_half_turn * 0.49).epsilon(0.005));
  CHECK(tube.area == Approx(2 * k_half_turn * (0.49 + 1.4)).epsilon(0.01));
}

TEMPLATE_TEST_CASE("Settled points lie on the surface, within its bounds, with outward normals", "",
                   float, double) {
  using Real = TestType;
  Random random(2107);
  const double rounding = static_cast<double>(ulps<Real>(1));
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const Solid solid = random_solid(random);
    const Real* parameters = parameters_of<Real>(solid);
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray = random_ray(random, 4);
      const Hits<Real> found = hits_on<Real>(solid, ray.origin, ray.direction);
      for (int j = 0; j < found.count; ++j) {
        const Hit<Real>& hit = found.hits[j];
        const Vector<double> p = ray.origin + ray.direction * static_cast<double>(hit.distance);
        const FacePoint<Real> on_face = settle(Vector<Real>(p), hit.face, parameters);
        const Vector<Real>& settled = on_face.position;
        const Vector<double> on(settled);
        REQUIRE(magnitude(on) <= 1);
        const Vector<Real> outward = on_face.normal;
        REQUIRE(length(outward) > Real(0));
        CAPTURE(i, k, j, static_cast<int>(hit.face), on.x, on.y, on.z);
        if (hit.face != k_surface) {
          REQUIRE(magnitude(on) == 1);
          REQUIRE(glm::dot(Vector<double>(outward), on) == 1);
          continue;
        }
        const Vector<double> gradient = gradient_at(solid, on);
        if (glm::length(gradient) > 0.05 && magnitude(on) < 1) {
          ++checked;
          REQUIRE(std::fabs(value_at(solid, on)) < 200 * rounding);
          const Vector<double> unit = glm::normalize(Vector<double>(outward));
          REQUIRE(glm::length(unit - glm::normalize(gradient)) < 1e-4);
        }
      }
    }
  }
  CHECK(checked > 1000);
}

TEMPLATE_TEST_CASE("A point off the surface settles on it nearby", "", float, double) {
  using Real = TestType;
  Random random(2110);
  const double rounding = static_cast<double>(ulps<Real>(1));
  int checked = 0;
  for (int i = 0; i < 3000; ++i) {
    const Solid solid = random_solid(random);
    const Ray<double> ray = random_ray(random, 4);
    const Hits<double> found = hits_on<double>(solid, ray.origin, ray.direction);
    if (found.count == 0 || found.hits[0].face != k_surface) {
      continue;
    }
    const double step = 1e-4;
    const Vector<Real> off(ray.origin + ray.direction * found.hits[0].distance +
                           random.direction() * step);
    const Vector<double> on(settle(off, k_surface, parameters_of<Real>(solid)).position);
    const double slope = glm::length(gradient_at(solid, on));
    if (slope > 0.1 && magnitude(on) < 1) {
      ++checked;
      CAPTURE(i, slope);
      REQUIRE(std::fabs(value_at(solid, on)) < 1e-3 * slope * step + 200 * rounding);
      REQUIRE(glm::length(on - Vector<double>(off)) < 2 * step);
    }
  }
  CHECK(checked > 500);
}

TEST_CASE("A singular point has a normal, on the side that is outside") {
  const Solid double_cone = solid_of({{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, -1}});
  const Solid planes = solid_of({{1, 1, 0, 1}, {0, 2, 0, 1}});
  const Vector<float> apex(0, 0, 0);
  CHECK(settle(apex, k_surface, double_cone.as_float.data()).normal.z == 0);
  CHECK(settle(apex, k_surface, planes.as_float.data()).normal.y != 0);
  const Solid flat = solid_of({{8, 0, 0, 1}});
  CHECK(glm::length(settle(apex, k_surface, flat.as_float.data()).normal) == 1);
}

TEMPLATE_TEST_CASE("A ray that leaves a convex solid does not meet it again", "", float, double) {
  using Real = TestType;
  Random random(2108);
  for (int i = 0; i < 20000; ++i) {
    const Solid solid = superquadric(2 * (1 + random.below(4)), random.uniform(0.7, 1));
    const Real* parameters = parameters_of<Real>(solid);
    const Vector<double> target = random.in_cube(0.6);
    const Vector<double> direction = random.direction();
    const Hits<Real> found = hits_on<Real>(solid, target - direction * 3.0, direction);
    if (found.count == 0) {
      continue;
    }
    const Vector<Real> p =
        Vector<Real>(target - direction * 3.0) + Vector<Real>(direction) * found.hits[0].distance;
    const FacePoint<Real> on_face = settle(p, found.hits[0].face, parameters);
    const Vector<Real>& settled = on_face.position;
    const Vector<Real> outward = normalize(on_face.normal);
    const Vector<Real> start = settled + outward * ulps<Real>(32);
    const Vector<double> axis(outward);
    const Vector<double> away =
        random.direction_around(glm::normalize(axis), random.magnitude(1e-6, 1));
    const Hits<Real> again = hits_on<Real>(solid, Vector<double>(start), away);
    for (int k = 0; k < again.count; ++k) {
      CAPTURE(i, k, glm::dot(axis, away));
      REQUIRE(again.hits[k].distance <= ulps<Real>(64));
    }
  }
}

}  // namespace
}  // namespace maquette::firmware::algebraic
