#include "firmware/ray_tree.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Placement;
using trial::Random;

Placement box_between(const Vector<double>& low, const Vector<double>& high) {
  return concatenate(trial::moved((low + high) * 0.5), trial::scaled((high - low) * 0.5));
}

double frontal_reflection(double index) {
  return (index - 1) * (index - 1) / ((index + 1) * (index + 1));
}

/// The rays that a point of a given surface spawns for a view, with how many they are.
template <class Real>
struct Spawned {
  PendingRay<Real> rays[2];
  std::int32_t count;
  RayCounts counts;
};

/// The border between void and a body of surface 0, as the view sees it from `before`.
Spawned<double> spawned_at(const Surface<double>& surface, const Vector<double>& normal,
                           const Vector<double>& direction, bool from_inside,
                           double minimum_weight) {
  Model model;
  model.surfaces = {surface};
  model.minimum_weight = minimum_weight;
  BuiltFrame<double> built(model, model.add(kind_of<sphere::Kind>, trial::unmoved()));
  SurfacePoint<double> point{};
  point.normal = normal;
  point.before = from_inside ? 0 : k_void;
  point.after = from_inside ? k_void : 0;
  PendingRay<double> parent{};
  parent.weight = {1, 1, 1};
  Spawned<double> spawned{};
  spawned.count = spawn(built.frame, point, view_of(built.frame, point, direction), parent,
                        spawned.rays, 0, spawned.counts);
  return spawned;
}

TEST_CASE("Mirrored and refracted rays go where optics sends them") {
  Random random(1101);
  for (int i = 0; i < 2000; ++i) {
    const double index = random.uniform(1.05, 2.5);
    const bool from_inside = random.coin();
    const double relative = from_inside ? 1 / index : index;
    const Vector<double> normal = random.direction();
    const double cosine = random.uniform(0.05, 1);
    const Vector<double> direction = random.direction_around(normal, -cosine);
    const auto spawned = spawned_at(trial::glass_surface(index), normal, direction, from_inside, 0);
    const Vector<double> mirrored = spawned.rays[0].ray.direction;
    REQUIRE(spawned.count == 2);
    REQUIRE(glm::length(mirrored) == Approx(1));
    REQUIRE(glm::dot(mirrored, normal) == Approx(cosine).margin(1e-12));
    REQUIRE(glm::length(mirrored - direction - normal * (2 * cosine)) < 1e-12);

    const double sine = std::sqrt(1 - cosine * cosine);
    if (sine / relative > 0.999) {
      continue;
    }
    const Vector<double> bent = spawned.rays[1].ray.direction;
    REQUIRE(glm::length(bent) == Approx(1));
    REQUIRE(glm::length(glm::cross(bent, normal)) == Approx(sine / relative).margin(1e-9));
    REQUIRE(glm::dot(bent, normal) < 0);
    // In the plane of incidence, on the same side.
    REQUIRE(glm::dot(bent, glm::cross(normal, direction)) == Approx(0).margin(1e-12));
    REQUIRE(glm::length(glm::cross(bent, normal) - glm::cross(direction, normal) / relative) <
            1e-9);
  }
}

TEST_CASE("Reflection beyond the critical angle leaves nothing to refract") {
  const Vector<double> normal(0, 0, 1);
  Random random(1102);
  const auto spawned = spawned_at(trial::glass_surface(1.5), normal,
                                  random.direction_around(normal, -0.5), true, 1e-9);
  CHECK(spawned.count == 1);
  CHECK(spawned.counts.reflected == 1);
  CHECK(spawned.counts.refracted == 0);
  CHECK(spawned.rays[0].weight.x == 1);
}

TEST_CASE("The weights of what a ray spawns never sum to more than its own") {
  Random random(1103);
  for (int i = 0; i < 5000; ++i) {
    Surface<double> surface =
        random.coin() ? trial::mirror_surface() : trial::glass_surface(random.magnitude(1.01, 3));
    surface.specular = random.uniform();
    const Vector<double> normal = random.direction();
    const auto spawned =
        spawned_at(surface, normal, random.direction_around(normal, -random.uniform(1e-3, 1)),
                   random.coin(), 0);
    for (int color = 0; color < 3; ++color) {
      double sum = 0;
      for (std::int32_t ray = 0; ray < spawned.count; ++ray) {
        REQUIRE(spawned.rays[ray].weight[color] >= 0);
        sum += spawned.rays[ray].weight[color];
      }
      REQUIRE(sum <= surface.specular + 1e-12);
    }
  }
}

TEST_CASE("Rays below the least weight are not cast") {
  const Vector<double> normal(0, 0, 1);
  const double reflected = frontal_reflection(1.5);
  const Vector<double> down(0, 0, -1);
  const auto glass = trial::glass_surface(1.5);
  CHECK(spawned_at(glass, normal, down, false, reflected * 0.99).count == 2);
  CHECK(spawned_at(glass, normal, down, false, reflected * 1.01).count == 1);
  CHECK(spawned_at(glass, normal, down, false, 1 - reflected * 0.99).count == 0);
}

/// The luminance in the middle of the picture.
Color<double> seen_along_axis(const Model& model, NodeIndex root) {
  BuiltFrame<double> built(model, root);
  const RayQuery<double> query{{{0, 0, 0}, {0, 0, 1}}, far_away<double>(), true, 32, 24, k_no_node};
  Sight<double> sight;
  return luminance(built.frame, query, built.area(), sight);
}

TEST_CASE("A lit wall is seen through a slab by exp(-a t) (1 - F)^2") {
  const double index = 1.5;
  const double thickness = 0.8;
  const Color<double> absorption(0.2, 0.7, 1.9);
  const Color<double> paint(0.9, 0.6, 0.3);
  Model model;
  model.surfaces = {trial::matt_surface(paint)};
  model.ambient = {1, 1, 1};
  model.ray_depth = 2;  // without the light that goes to and fro
  const SurfaceIndex glass = model.add(trial::glass_surface(index, absorption));
  const NodeIndex slab =
      model.add(kind_of<box::Kind>, box_between({-5, -5, 3}, {5, 5, 3 + thickness}), glass);
  const NodeIndex wall = model.add(kind_of<box::Kind>, box_between({-50, -50, 6}, {50, 50, 7}));
  const Color<double> seen =
      seen_along_axis(model, model.combine(BooleanOperator::union_of, slab, wall));
  const double passage = std::pow(1 - frontal_reflection(index), 2);
  for (int color = 0; color < 3; ++color) {
    CHECK(seen[color] ==
          Approx(paint[color] * passage * std::exp(-absorption[color] * thickness)).epsilon(1e-9));
  }
}

TEST_CASE("With depth the slab's inner reflections are seen too, and no more than there is") {
  const double index = 1.5;
  Model model;
  model.surfaces = {trial::matt_surface()};
  model.ambient = {1, 1, 1};
  model.background = {1, 1, 1};
  model.ray_depth = 30;
  model.minimum_weight = 1e-12;
  const SurfaceIndex glass = model.add(trial::glass_surface(index));
  const NodeIndex slab = model.add(kind_of<box::Kind>, box_between({-5, -5, 3}, {5, 5, 4}), glass);
  const NodeIndex wall = model.add(kind_of<box::Kind>, box_between({-50, -50, 6}, {50, 50, 7}));
  const Color<double> seen =
      seen_along_axis(model, model.combine(BooleanOperator::union_of, slab, wall));
  CHECK(seen.x == Approx(1).epsilon(1e-9));
}

TEST_CASE("In a surrounding of brightness 1 nothing looks brighter") {
  Random random(1104);
  for (int trial = 0; trial < 40; ++trial) {
    Model model;
    model.surfaces = {trial::matt_surface(), trial::mirror_surface(), trial::glass_surface(1.5),
                      trial::glass_surface(1.3, {0.1, 0.2, 0.3})};
    model.surfaces[0].specular = 0.3;
    model.ambient = model.background = {1, 1, 1};
    model.ray_depth = 6;
    model.minimum_weight = 0.001;
    const auto tree = trial::random_tree(random, model, 6, {0, 0, 20}, 10);
    BuiltFrame<double> built(tree.model, tree.root);
    for (std::int16_t row = 0; row < model.rows; row = static_cast<std::int16_t>(row + 6)) {
      for (std::int16_t column = 0; column < model.columns; ++column) {
        Sight<double> sight;
        const auto query = primary_ray(built.frame.database, column, row);
        const Color<double> seen = luminance(built.frame, query, built.area(), sight);
        REQUIRE((seen.x <= 1 + 1e-9 && seen.y <= 1 + 1e-9 && seen.z <= 1 + 1e-9));
        REQUIRE((seen.x >= 0 && seen.y >= 0 && seen.z >= 0));
      }
    }
  }
}

TEST_CASE("A half-space of glass has no bottom") {
  Model model;
  model.background = {0.25, 0.5, 1};
  const SurfaceIndex water = model.add(trial::glass_surface(1.33));
  const SurfaceIndex ink = model.add(trial::glass_surface(1.33, {1, 1, 1}));
  const Placement facing =
      concatenate(trial::moved({0, 0, 5}), trial::turned({1, 0, 0}, elementary::k_pi));
  const NodeIndex sea = model.add(kind_of<half_space::Kind>, facing, water);
  const NodeIndex black_sea = model.add(kind_of<half_space::Kind>, facing, ink);
  const Color<double> seen = seen_along_axis(model, sea);
  CHECK(seen.x == Approx(0.25));
  CHECK(seen.y == Approx(0.5));
  CHECK(seen.z == Approx(1));
  CHECK(seen_along_axis(model, black_sea).z == Approx(frontal_reflection(1.33)));
}

TEST_CASE("A mirror shows what stands behind the viewer") {
  Model model;
  model.surfaces = {trial::matt_surface({0.25, 0.5, 0.75})};
  model.ambient = {1, 1, 1};
  const SurfaceIndex silver = model.add(trial::mirror_surface());
  const Surface<double>& metal = model.surfaces[silver];
  const NodeIndex mirror =
      model.add(kind_of<box::Kind>, box_between({-5, -5, 3}, {5, 5, 4}), silver);
  const NodeIndex wall = model.add(kind_of<box::Kind>, box_between({-9, -9, -7}, {9, 9, -6}));
  const Color<double> reflected(conductor_reflection(1.0, metal.index.x, metal.extinction.x),
                                conductor_reflection(1.0, metal.index.y, metal.extinction.y),
                                conductor_reflection(1.0, metal.index.z, metal.extinction.z));
  const Color<double> seen =
      seen_along_axis(model, model.combine(BooleanOperator::union_of, mirror, wall));
  CHECK(seen.x == Approx(0.25 * reflected.x));
  CHECK(seen.y == Approx(0.5 * reflected.y));
  CHECK(seen.z == Approx(0.75 * reflected.z));
}

TEST_CASE("Without specular surfaces, depth or lights no such rays are cast") {
  const auto counts_of = [](Model model) {
    const NodeIndex root = model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 5}), 0);
    BuiltFrame<float> built(model, root);
    return built.pixel(32, 24).rays;
  };
  Model matt;
  matt.lights = {{{0, 0, -20}, {1, 1, 1}}};
  CHECK(counts_of(matt).primary == 1);
  CHECK(counts_of(matt).reflected == 0);
  CHECK(counts_of(matt).refracted == 0);
  CHECK(counts_of(matt).shadow == 1);
  Model glass = matt;
  glass.surfaces = {trial::glass_surface(1.5)};
  CHECK(counts_of(glass).reflected > 0);
  CHECK(counts_of(glass).refracted > 0);
  glass.ray_depth = 0;
  CHECK(counts_of(glass).reflected == 0);
  CHECK(counts_of(glass).refracted == 0);
  matt.needs.shadows = false;
  CHECK(counts_of(matt).shadow == 0);
}

}  // namespace
}  // namespace maquette::firmware
