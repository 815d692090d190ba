#include "firmware/primitives/shell.hpp"

#include <cmath>
#include <vector>

#include "firmware/extent.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/revolution_solids.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::shell {
namespace {

using namespace trial;

template <class Real>
Hits<Real> shell_hits(const Solid& solid, const Vector<double>& origin,
                      const Vector<double>& direction) {
  Hits<Real> found;
  found.count = intersect<Real>({Vector<Real>(origin), Vector<Real>(direction)},
                                parameters_of<Real>(solid), found.hits);
  return found;
}

/// Whether another hit is near enough for rounding to have put them in another order.
template <class Real>
bool is_near_another(const Hits<Real>& found, int i, double size) {
  const double margin = 2e-3 / size;
  const auto apart = [&](int a, int b) {
    return static_cast<double>(found.hits[b].distance - found.hits[a].distance);
  };
  return (i > 0 && apart(i - 1, i) < margin) || (i + 1 < found.count && apart(i, i + 1) < margin);
}

TEMPLATE_TEST_CASE("A shell is met where its solid is but for the discs, and from which side", "",
                   float, double) {
  using Real = TestType;
  Random random(5201);
  int from_behind = 0;
  int on_discs = 0;
  for (int i = 0; i < 300; ++i) {
    const Solid solid = random.coin() ? random_vase(random) : random_ring(random, 0.8);
    for (int k = 0; k < 60; ++k) {
      const Ray<double> ray = random_ray(random, 4);
      const Hits<Real> closed = hits_on<Real>(solid, ray.origin, ray.direction);
      const Hits<Real> open = shell_hits<Real>(solid, ray.origin, ray.direction);
      int next = 0;
      CAPTURE(i, k, closed.count, open.count);
      for (int hit = 0; hit < closed.count; ++hit) {
        if (closed.hits[hit].face >= revolution::k_first_disc) {
          ++on_discs;
          continue;
        }
        CAPTURE(hit, next);
        REQUIRE(next + 1 < open.count);
        const Hit<Real>& in = open.hits[next++];
        const Hit<Real>& out = open.hits[next++];
        REQUIRE(in.distance == closed.hits[hit].distance);
        REQUIRE(out.distance == in.distance);
        if (!is_near_another(closed, hit, glm::length(ray.direction))) {
          REQUIRE(in.face % k_from_behind == closed.hits[hit].face);
          REQUIRE(out.face == in.face);
          // What a ray leaves the solid by it meets from behind.
          REQUIRE((in.face >= k_from_behind) == (hit % 2 == 1));
          from_behind += hit % 2;
        }
      }
      REQUIRE(next == open.count);
    }
  }
  CHECK(from_behind > 3000);
  CHECK(on_discs > 1000);
}

TEMPLATE_TEST_CASE("Points of a shell settle on it, with normals to where the ray came from", "",
                   float, double) {
  using Real = TestType;
  Random random(5202);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const Solid solid = random.coin() ? random_vase(random) : random_ring(random, 0.3);
    const Real* parameters = parameters_of<Real>(solid);
    Box<Real> box{};
    REQUIRE(revolution::bounds(parameters, box));
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray = random_ray(random, 4);
      const Vector<double> way = glm::normalize(ray.direction);
      const Hits<Real> found = shell_hits<Real>(solid, ray.origin, ray.direction);
      REQUIRE(found.count % 2 == 0);
      REQUIRE(found.count <= hit_limit(parameters));
      for (int j = 0; j < found.count; j += 2) {
        const Vector<double> p =
            ray.origin + ray.direction * static_cast<double>(found.hits[j].distance);
        const FacePoint<Real> settled = settle(Vector<Real>(p), found.hits[j].face, parameters);
        const Vector<double> on(settled.position);
        CAPTURE(i, k, j, static_cast<int>(found.hits[j].face), on.x, on.y, on.z);
        REQUIRE(glm::length(on - p) < 1e-4);
        REQUIRE(place_of(solid, on).distance < 1e-5);
        REQUIRE(magnitude(higher(box.low, lower(settled.position, box.high)) - settled.position) <=
                ulps<Real>(4));
        const double cosine = glm::dot(glm::normalize(Vector<double>(settled.normal)), way);
        // Rays that graze the shell may be on either side of it within the rounding.
        if (std::fabs(cosine) > 2e-2) {
          ++checked;
          REQUIRE(cosine < 0);
        }
      }
    }
  }
  CHECK(checked > 1500);
}

/// A spiral of so many sections, which winds up around the axis of a long tube.
Solid long_tube(int sections) {
  std::vector<double> control;
  for (int i = 0; i < sections + 3; ++i) {
    const double z = -1 + 2.0 * (i - 1) / sections;
    control.insert(control.end(), {0.8 + 0.1 * std::sin(9 * z), z});
  }
  return solid_of(control, true);
}

TEMPLATE_TEST_CASE("Sections that share a face are told apart by the point", "", float, double) {
  using Real = TestType;
  Random random(5203);
  const Solid tube = long_tube(400);
  const Real* parameters = parameters_of<Real>(tube);
  for (int i = 0; i < 300; ++i) {
    const Ray<double> ray = random_ray(random, 4);
    const Hits<Real> found = shell_hits<Real>(tube, ray.origin, ray.direction);
    for (int k = 0; k < found.count; ++k) {
      const Vector<double> p =
          ray.origin + ray.direction * static_cast<double>(found.hits[k].distance);
      const FacePoint<Real> settled = settle(Vector<Real>(p), found.hits[k].face, parameters);
      CAPTURE(i, k, static_cast<int>(found.hits[k].face));
      REQUIRE(glm::length(Vector<double>(settled.position) - p) < 1e-4);
      const SurfacePlace<Real> place =
          surface_place(settled.position, found.hits[k].face, parameters);
      REQUIRE(static_cast<double>(place.v) ==
              Approx((static_cast<double>(settled.position.z) + 1) / 2).margin(5e-3));
    }
  }
}

TEMPLATE_TEST_CASE("A ray that leaves the outer side of a shell does not meet it again", "", float,
                   double) {
  using Real = TestType;
  Random random(5204);
  const Solid barrel =
      solid_of({0.4, -1.2, 0.7, -0.8, 0.9, -0.4, 1, 0, 0.9, 0.4, 0.7, 0.8, 0.4, 1.2}, true);
  const Real* parameters = parameters_of<Real>(barrel);
  int left = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector<double> target = random.in_cube(0.6);
    const Vector<double> direction = random.direction();
    const Hits<Real> found = shell_hits<Real>(barrel, target - direction * 3.0, direction);
    if (found.count == 0 || found.hits[0].face >= k_from_behind) {
      continue;
    }
    const Vector<Real> p =
        Vector<Real>(target - direction * 3.0) + Vector<Real>(direction) * found.hits[0].distance;
    const FacePoint<Real> settled = settle(p, found.hits[0].face, parameters);
    const Vector<Real> outward = normalize(settled.normal);
    const Vector<Real> start = settled.position + outward * ulps<Real>(32);
    const Vector<double> away =
        random.direction_around(glm::normalize(Vector<double>(outward)), random.magnitude(1e-6, 1));
    const Hits<Real> again = shell_hits<Real>(barrel, Vector<double>(start), away);
    ++left;
    for (int k = 0; k < again.count; ++k) {
      CAPTURE(i, k);
      REQUIRE(again.hits[k].distance <= ulps<Real>(64));
    }
  }
  CHECK(left > 5000);
}

}  // namespace
}  // namespace maquette::firmware::shell
