#include "firmware/shadow.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Placement;
using trial::Random;

/// Light along a segment; black when something opaque is in between.
template <class Real>
Color<double> light_over(BuiltFrame<Real>& built, const Vector<double>& from,
                         const Vector<double>& to) {
  const Vector<double> way = to - from;
  const Ray<Real> ray{trial::rounded<Real>(from), trial::rounded<Real>(glm::normalize(way))};
  Color<Real> light(constant<Real>(1), constant<Real>(1), constant<Real>(1));
  const auto crossings = built.crossings_of(from, glm::normalize(way));
  SurfaceIndex medium = k_void;
  first_ahead(crossings.data(), static_cast<std::int32_t>(crossings.size()), medium);
  if (!reaches(built.frame, ray, constant<Real>(glm::length(way)), k_no_node, medium,
               built.area().crossings, light)) {
    return {0, 0, 0};
  }
  return trial::exact(light);
}

Placement box_between(const Vector<double>& low, const Vector<double>& high) {
  return concatenate(trial::moved((low + high) * 0.5), trial::scaled((high - low) * 0.5));
}

/// The Fresnel reflection of a border at normal incidence.
double frontal_reflection(double index) {
  return (index - 1) * (index - 1) / ((index + 1) * (index + 1));
}

TEST_CASE("A slab lets through exp(-a t) (1 - F)^2 along its axis") {
  const double index = 1.5;
  const double thickness = 0.7;
  const Color<double> absorption(0.3, 1.1, 2.5);
  Model model;
  const SurfaceIndex glass = model.add(trial::glass_surface(index, absorption));
  const NodeIndex slab =
      model.add(kind_of<box::Kind>, box_between({-9, -9, 5}, {9, 9, 5 + thickness}), glass);
  BuiltFrame<double> built(model, slab);
  const double passage = 1 - frontal_reflection(index);
  const Color<double> light = light_over<double>(built, {0, 0, 0}, {0, 0, 10});
  const Color<double> half = light_over<double>(built, {0, 0, 0}, {0, 0, 5 + thickness / 2});
  for (int color = 0; color < 3; ++color) {
    const double a = absorption[color];
    CHECK(light[color] == Approx(std::exp(-a * thickness) * passage * passage).epsilon(1e-12));
    CHECK(half[color] == Approx(std::exp(-a * thickness / 2) * passage).epsilon(1e-12));
  }
  CHECK(light_over<double>(built, {0, 0, 6}, {0, 0, 10}) == Color<double>(1, 1, 1));
  CHECK(light_over<double>(built, {0, 0, 0}, {0, 0, 4}) == Color<double>(1, 1, 1));
}

TEST_CASE("The share of diffuse reflection lets nothing through") {
  Surface<double> milky = trial::glass_surface(1.5);
  milky.specular = 0.25;
  Model model;
  const SurfaceIndex surface = model.add(milky);
  BuiltFrame<double> built(
      model, model.add(kind_of<box::Kind>, box_between({-9, -9, 5}, {9, 9, 6}), surface));
  const double passage = 0.25 * (1 - frontal_reflection(1.5));
  CHECK(light_over<double>(built, {0, 0, 0}, {0, 0, 10}).x ==
        Approx(passage * passage).epsilon(1e-12));
}

TEST_CASE("Overlapping transparent bodies attenuate where each has its matter") {
  Model model;
  const SurfaceIndex red = model.add(trial::glass_surface(1.5, {0, 1, 1}));
  const SurfaceIndex blue = model.add(trial::glass_surface(1.5, {2, 2, 0}));
  const NodeIndex a = model.add(kind_of<box::Kind>, box_between({-9, -9, 1}, {9, 9, 3}), red);
  const NodeIndex b = model.add(kind_of<box::Kind>, box_between({-9, -9, 2}, {9, 9, 5}), blue);
  BuiltFrame<double> built(model, model.combine(BooleanOperator::union_of, a, b));
  const double passages = std::pow(1 - frontal_reflection(1.5), 2);
  const Color<double> light = light_over<double>(built, {0, 0, 0}, {0, 0, 9});
  CHECK(light.x == Approx(passages * std::exp(-2.0 * 2)).epsilon(1e-12));
  CHECK(light.y == Approx(passages * std::exp(-1.0 * 2 - 2.0 * 2)).epsilon(1e-12));
  CHECK(light.z == Approx(passages * std::exp(-1.0 * 2)).epsilon(1e-12));
}

TEST_CASE("What is left of a body behind the origin or beyond the source gives no shadow") {
  Model model;
  const SurfaceIndex glass = model.add(trial::glass_surface(1.5));
  const NodeIndex stone = model.add(kind_of<box::Kind>, box_between({-9, -9, -5}, {9, 9, 10}));
  const NodeIndex hole = model.add(kind_of<box::Kind>, box_between({-1, -1, -1}, {1, 1, 4}));
  const NodeIndex carved = model.combine(BooleanOperator::difference, stone, hole);
  const NodeIndex lens = model.add(kind_of<sphere::Kind>, trial::moved({30, 0, 0}), glass);
  for (const bool with_glass : {false, true}) {
    BuiltFrame<double> built(
        model, with_glass ? model.combine(BooleanOperator::union_of, carved, lens) : carved);
    CHECK(light_over<double>(built, {0, 0, 0}, {0, 0, 3}).x == 1);
    CHECK(light_over<double>(built, {0, 0, 0}, {0, 0, 5}).x == 0);
    CHECK(light_over<double>(built, {0, 0, 20}, {0, 0, 11}).x == 1);
    CHECK(light_over<double>(built, {0, 0, 20}, {0, 0, 3}).x == 0);
  }
  // Transparent matter holding the opaque body, so that combination alone knows.
  const NodeIndex bubble = model.add(kind_of<sphere::Kind>, trial::scaled({40, 40, 40}), glass);
  const NodeIndex hall = model.add(kind_of<box::Kind>, box_between({-1, -1, -1}, {1, 1, 4}));
  const NodeIndex filled = model.combine(BooleanOperator::union_of, bubble, stone);
  BuiltFrame<double> both(model, model.combine(BooleanOperator::difference, filled, hall));
  CHECK(light_over<double>(both, {0, 0, 0}, {0, 0, 3}).x == 1);
  CHECK(light_over<double>(both, {0, 0, 0}, {0, 0, 5}).x == 0);
}

/// Whether the segment runs through matter, by the crossings of the whole tree.
bool is_stopped(const std::vector<Crossing<double>>& crossings, double reach) {
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    if (crossings[i].medium != k_void && crossings[i].distance < reach &&
        crossings[i + 1].distance > 0) {
      return true;
    }
  }
  return false;
}

TEST_CASE("In random trees of opaque bodies shadow is where matter lies in between") {
  Random random(301);
  int stopped = 0;
  int differing = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto tree = trial::random_tree(random, Model{}, 1 + random.below(8), {0, 0, 20}, 10);
    BuiltFrame<double> built(tree.model, tree.root);
    for (int ray = 0; ray < 30; ++ray) {
      const Vector<double> from = Vector<double>(0, 0, 20) + random.in_cube(8);
      const Vector<double> to = Vector<double>(0, 0, 20) + random.in_cube(8);
      const bool reference =
          is_stopped(built.crossings_of(from, glm::normalize(to - from)), glm::length(to - from));
      stopped += reference ? 1 : 0;
      differing += reference == (light_over<double>(built, from, to).x == 0) ? 0 : 1;
    }
  }
  CHECK(stopped > 1000);
  CHECK(differing == 0);
}

TEST_CASE("No light grows on its way, and it is the same both ways") {
  Random random(302);
  int attenuated = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Model glasses;
    glasses.surfaces = {trial::glass_surface(1.5, {0.1, 0.2, 0.3}), trial::glass_surface(1.3)};
    const auto tree = trial::random_tree(random, glasses, 1 + random.below(5), {0, 0, 20}, 10);
    BuiltFrame<double> built(tree.model, tree.root);
    for (int ray = 0; ray < 20; ++ray) {
      const Vector<double> from = Vector<double>(0, 0, 20) + random.in_cube(8);
      const Vector<double> to = Vector<double>(0, 0, 20) + random.in_cube(8);
      const Color<double> there = light_over<double>(built, from, to);
      const Color<double> back = light_over<double>(built, to, from);
      attenuated += there.x < 0.99 ? 1 : 0;
      for (int color = 0; color < 3; ++color) {
        REQUIRE(there[color] <= 1);
        REQUIRE(there[color] >= 0);
        REQUIRE(there[color] == Approx(back[color]).epsilon(1e-7).margin(1e-9));
      }
    }
  }
  CHECK(attenuated > 500);
}

}  // namespace
}  // namespace maquette::firmware
