#include "firmware/primitives/primitive_table.hpp"

#include <cmath>

#include "firmware/extent.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/convex_solids.hpp"
#include "tests/firmware/random_cases.hpp"

/// Laws of the convex primitives in their local frames, against their definitions as sets of
/// points.
namespace maquette::firmware {
namespace {

using trial::ConvexSolid;
using trial::k_convex_solids;
using trial::Random;

template <class Real>
struct Hits {
  Hit<Real> hits[k_convex_hit_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(PrimitiveKind kind, double top, const Vector<double>& origin,
                   const Vector<double>& direction) {
  const Real parameter = constant<Real>(top);
  Hits<Real> found;
  found.count = primitive_of<Real>(kind).intersect({Vector<Real>(origin), Vector<Real>(direction)},
                                                   &parameter, found.hits);
  return found;
}

/// Whether the ray's part between its hits, and no other, lies inside. Points nearer to the surface
/// than `margin` say nothing.
template <class Real>
bool is_span_right(const ConvexSolid& solid, double top, const Vector<double>& origin,
                   const Vector<double>& direction, double margin) {
  const Hits<Real> found = hits_on<Real>(solid.kind, top, origin, direction);
  if (found.count == 2 && !(found.hits[0].distance < found.hits[1].distance)) {
    return false;
  }
  for (int step = -50; step <= 50; ++step) {
    const double t = step * 0.16 + 0.013;
    const double outside = solid.outside_by(top, origin + direction * t);
    const bool is_between = found.count == 2 && static_cast<double>(found.hits[0].distance) < t &&
                            t < static_cast<double>(found.hits[1].distance);
    if (absolute(outside) > margin && is_between != (outside < 0)) {
      return false;
    }
  }
  return true;
}

TEMPLATE_TEST_CASE("The span of a random ray is what lies inside", "", float, double) {
  Random random(1401);
  const double margin = 50 * static_cast<double>(ulps<TestType>(1));
  for (int i = 0; i < 4000; ++i) {
    const ConvexSolid& solid = k_convex_solids[i % trial::k_convex_solid_count];
    const double top = random.coin() ? 0 : random.uniform(0.05, 0.95);
    const Vector<double> direction = random.direction() * random.magnitude(0.3, 3);
    CAPTURE(i, static_cast<int>(solid.kind), top);
    REQUIRE(is_span_right<TestType>(solid, top, random.in_cube(1.6), direction, margin));
  }
}

/// Coordinates 0, +-1/2, +-1 of a number below 125.
Vector<double> lattice_point(int number) {
  return Vector<double>(number % 5 - 2, number / 5 % 5 - 2, number / 25 - 2) * 0.5;
}

TEMPLATE_TEST_CASE(
    "Rays along axes, faces, edges, through the apex and the centre are no exception", "", float,
    double) {
  for (const ConvexSolid& solid : k_convex_solids) {
    for (int from = 0; from < 125; ++from) {
      for (int to = 0; to < 125; ++to) {
        const Vector<double> direction = lattice_point(to);
        if (direction != Vector<double>(0, 0, 0)) {
          const double top = from % 2 == 0 ? 0 : 0.5;
          CAPTURE(static_cast<int>(solid.kind), from, to);
          REQUIRE(is_span_right<TestType>(solid, top, lattice_point(from), direction, 1e-5));
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("Settled points lie on the surface, within its bounds, with outward normals", "",
                   float, double) {
  using Real = TestType;
  Random random(1402);
  const double rounding = 8 * static_cast<double>(ulps<Real>(1));
  for (int i = 0; i < 10000; ++i) {
    const ConvexSolid& solid = k_convex_solids[i % trial::k_convex_solid_count];
    const Primitive<Real>& primitive = primitive_of<Real>(solid.kind);
    const Real top = constant<Real>(random.coin() ? 0 : random.uniform(0.05, 0.95));
    const double exact_top = static_cast<double>(top);
    const Vector<double> origin = random.in_cube(3);
    const Vector<double> direction = glm::normalize(random.in_cube() - origin);
    const Hits<Real> found = hits_on<Real>(solid.kind, exact_top, origin, direction);
    for (int k = 0; k < found.count; ++k) {
      const Hit<Real>& hit = found.hits[k];
      if (absolute(hit.distance) >= far_away<Real>()) {
        continue;  // a half-space has no end there
      }
      const Vector<Real> p = Vector<Real>(origin) + Vector<Real>(direction) * hit.distance;
      const FacePoint<Real> settled = primitive.settle(p, hit.face, &top);
      const Vector<double> on(settled.position);
      REQUIRE(absolute(solid.outside_by(exact_top, on)) <= rounding);
      const Vector<double> normal = glm::normalize(Vector<double>(settled.normal));
      const double step = 1e-3;
      REQUIRE(solid.outside_by(exact_top, on + normal * step) > 0.5 * step);
      const double along_ray = glm::dot(normal, direction);
      CAPTURE(static_cast<int>(solid.kind), k, static_cast<int>(hit.face), along_ray, on.x, on.y,
              on.z);
      REQUIRE((k == 0 ? along_ray < rounding : along_ray > -rounding));
      Box<Real> box{};
      if (primitive.bounds(&top, box)) {
        REQUIRE(magnitude(higher(box.low, lower(settled.position, box.high)) - settled.position) <=
                rounding);
      }
    }
  }
}

TEMPLATE_TEST_CASE("A point that rounding has brought onto the axis settles to numbers", "", float,
                   double) {
  using Real = TestType;
  const Real zero = constant<Real>(0);
  const Real top = zero;
  for (const ConvexSolid& solid : k_convex_solids) {
    const Primitive<Real>& primitive = primitive_of<Real>(solid.kind);
    for (std::uint8_t face = 0; face < 3; ++face) {
      const FacePoint<Real> settled = primitive.settle({zero, zero, zero}, face, &top);
      const Vector<Real> normal = normalize(settled.normal);
      CAPTURE(static_cast<int>(solid.kind), static_cast<int>(face));
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(std::isfinite(settled.position[axis]));
        CHECK(std::isfinite(normal[axis]));
      }
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
