#include "sim/primitives/primitive_table.hpp"

#include <vector>

#include "firmware/extent.hpp"
#include "firmware/preprocess.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/stability/sample_solids.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

/// Laws of every primitive of the table, tried on all its solids that scenes show.
namespace maquette::sim {
namespace {

using firmware::Hit;
using firmware::trial::Random;

const std::vector<SolidFamily>& families() {
  static const std::vector<SolidFamily> all =
      solid_families(shipped_scenes(MAQUETTE_PROJECT_DIRECTORY "/scenes"));
  return all;
}

std::vector<double> parameters_of(const Object& solid) {
  Scene scene;
  scene.surfaces.emplace_back().name = solid.surface;
  scene.object = solid;
  return object_tree_of(scene).leaves.front().parameters;
}

/// The solids of a family in one number type, in their local frames.
template <class Real>
struct Sample {
  const SolidFamily& family;
  const firmware::Primitive<Real>& primitive;
  std::vector<Real> parameters;
  firmware::Box<Real> box{};
  std::vector<Hit<Real>> hits;
  firmware::Ray<Real> ray{};

  Sample(const SolidFamily& of, const Object& solid)
      : family(of), primitive(firmware::primitive_of<Real>(of.kind)) {
    for (const double parameter : parameters_of(solid)) {
      parameters.push_back(static_cast<Real>(parameter));
    }
    primitive.bounds(parameters.data(), box);
    hits.resize(static_cast<std::size_t>(firmware::k_primitive_hit_limit));
  }

  /// Hits of a random ray at the box, from outside or inside.
  int shoot(Random& random) {
    const firmware::Vector<Real> aim(random.in_cube());
    const firmware::Vector<Real> half = (box.high - box.low) * Real(0.5);
    ray.direction = firmware::Vector<Real>(random.direction() * random.magnitude(0.3, 3));
    ray.origin =
        box.low + half + aim * half - ray.direction * static_cast<Real>(random.uniform(0, 4));
    return primitive.intersect(ray, parameters.data(), hits.data());
  }
  [[nodiscard]] firmware::FacePoint<Real> settled(const firmware::Vector<Real>& point,
                                                  std::uint8_t face) const {
    return primitive.settle(point, face, parameters.data());
  }
};

/// Calls `check` with every bounded solid of every primitive after each of many rays.
template <class Real, class Check>
void for_rays(std::uint32_t seed, Check check) {
  Random random(seed);
  for (const SolidFamily& family : families()) {
    INFO(family.name);
    for (const Object& solid : family.solids) {
      Sample<Real> sample(family, solid);
      for (int ray = 0; ray < (family.is_bounded ? 200 : 0); ++ray) {
        const int count = sample.shoot(random);
        CAPTURE(ray, count);
        check(sample, count);
      }
    }
  }
}

}  // namespace

TEST_CASE("A primitive is found by its name and described at its place") {
  for (std::size_t kind = 0; kind < primitive_table().size(); ++kind) {
    const PrimitiveDescription& primitive = *primitive_table()[kind];
    CHECK(find_primitive(primitive.name) == &primitive);
    CHECK(&description_of(static_cast<firmware::PrimitiveKind>(kind)) == &primitive);
  }
  CHECK(find_primitive("teapot") == nullptr);
}

TEMPLATE_TEST_CASE("Hits are in order, even in number and no more than a primitive says", "", float,
                   double) {
  int met = 0;
  for_rays<TestType>(3101, [&](const Sample<TestType>& sample, int count) {
    met += count > 0 ? 1 : 0;
    REQUIRE(count % 2 == 0);
    REQUIRE(count <= sample.primitive.hit_limit(sample.parameters.data()));
    REQUIRE((!sample.primitive.is_convex || count <= firmware::k_convex_hit_limit));
    for (int i = 1; i < count; ++i) {
      REQUIRE(sample.hits[static_cast<std::size_t>(i) - 1].distance <=
              sample.hits[static_cast<std::size_t>(i)].distance);
    }
  });
  CHECK(met > 1000);
}

TEMPLATE_TEST_CASE("A hit settles nearby, within the bounds, where it stays", "", float, double) {
  using Real = TestType;
  using Vector = firmware::Vector<Real>;
  // Hits are known to some ulps of the surface, which is far along a ray that grazes it.
  const Real near = static_cast<Real>(1e-4);
  const Real rounding = firmware::ulps<Real>(32);
  for_rays<Real>(3102, [&](const Sample<Real>& sample, int count) {
    for (int i = 0; i < count; ++i) {
      const Hit<Real>& hit = sample.hits[static_cast<std::size_t>(i)];
      if (!(hit.distance > 0)) {
        continue;  // where a span around the origin begins need not be known
      }
      const Vector point = sample.ray.origin + sample.ray.direction * hit.distance;
      const Vector on = sample.settled(point, hit.face).position;
      CAPTURE(i, static_cast<int>(hit.face), point.x, point.y, point.z, on.x, on.y, on.z);
      REQUIRE(firmware::magnitude(on - point) < near);
      const Vector inside = firmware::higher(sample.box.low, firmware::lower(on, sample.box.high));
      REQUIRE(firmware::magnitude(on - inside) < rounding);
      REQUIRE(firmware::magnitude(sample.settled(on, hit.face).position - on) < rounding);
      if (firmware::fits_unit_ball(sample.family.kind, firmware::Primitives{})) {
        REQUIRE(firmware::length(on) < 1 + rounding);
      }
    }
  });
}

}  // namespace maquette::sim
