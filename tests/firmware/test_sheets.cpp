#include <cmath>
#include <utility>
#include <vector>

#include "firmware/primitives/shell.hpp"
#include "firmware/shadow.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/generatrices.hpp"
#include "tests/firmware/patch_sets.hpp"
#include "tests/firmware/test_frame.hpp"

/// Patches and shells without thickness in a scene: each hit is a span of no length.
namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Placement;
using trial::Random;

/// z = bend (x^2 + y^2), x and y in [-0.9, 0.9].
trial::ControlNets bowl(double bend) {
  const double at[4] = {-0.9, -0.3, 0.3, 0.9};
  const double squared[4] = {0.81, -0.27, -0.27, 0.81};
  return {trial::net_of([&](int i, int k) {
    return Vector<double>(at[i], at[k], bend * (squared[i] + squared[k]));
  })};
}

/// The same as far as x^2 + y^2 = 1.62, which is farther everywhere.
std::vector<double> bowl_shell(double bend) {
  const double edge = 1.62;
  const double r = std::sqrt(edge);
  return trial::converted<double>(
      trial::given_sections({0, 0, r / 3, 0, r * 2 / 3, bend * edge / 3, r, bend * edge}, true));
}

enum class Sheet { patches, shell };

NodeIndex add_bowl(Model& model, Sheet sheet, double bend, const Placement& to_scene) {
  return sheet == Sheet::shell ? model.add(kind_of<shell::Kind>, to_scene, 0, bowl_shell(bend))
                               : model.add(kind_of<patches::Kind>, to_scene, 0,
                                           trial::parameters_of<double>(
                                               bowl(bend), false, trial::SearchMethod::roots));
}

Sheet either(Random& random) { return random.coin() ? Sheet::shell : Sheet::patches; }

/// A bowl at some distance from the eye, and points on either side of its middle.
struct Setting {
  Model model;
  Placement placement;
  NodeIndex root;

  Setting(Random& random, double bend)
      : placement(random.placement(random.in_cube(4), random.magnitude(1e-2, 1e2), 1)) {
    root = add_bowl(model, either(random), bend, placement);
  }
  [[nodiscard]] Vector<double> place(const Vector<double>& local) const {
    return transform_point(placement, local);
  }
};

TEMPLATE_TEST_CASE("A sheet is seen from both sides, with its normal to the viewer", "", float,
                   double) {
  Random random(2401);
  for (int i = 0; i < 400; ++i) {
    const Setting setting(random, random.uniform(0, 0.5));
    BuiltFrame<TestType> built(setting.model, setting.root);
    const double side = random.coin() ? 1 : -1;
    const Vector<double> from = setting.place(random.in_cube(0.4) + Vector<double>(0, 0, 3 * side));
    const Vector<double> direction = glm::normalize(setting.place(random.in_cube(0.3)) - from);
    const auto crossings = built.crossings_of(from, direction);
    CAPTURE(i, side);
    REQUIRE(crossings.size() == 2);
    REQUIRE(crossings[0].distance == crossings[1].distance);
    REQUIRE(crossings[0].medium == 0);
    REQUIRE(crossings[1].medium == k_void);
    const RayQuery<TestType> query{
        {trial::rounded<TestType>(from), trial::rounded<TestType>(direction)},
        far_away<TestType>(),
        false,
        0,
        0};
    const auto point = surface_point(built.frame, query, crossings[0], k_void);
    REQUIRE(glm::dot(trial::exact(point.normal), direction) < -0.1);
    REQUIRE(point.surface == 0);
  }
}

TEMPLATE_TEST_CASE("A sheet stops the light from one side to the other and no other light", "",
                   float, double) {
  using Real = TestType;
  Random random(2402);
  for (int i = 0; i < 600; ++i) {
    const Setting setting(random, 0.3);
    BuiltFrame<Real> built(setting.model, setting.root);
    const Vector<double> above = random.in_cube(0.4) + Vector<double>(0, 0, 2);
    const Vector<double> below = random.in_cube(0.4) - Vector<double>(0, 0, 1.5);
    const Vector<double> beside = random.in_cube(0.4) + Vector<double>(2.5, 0, -1.5);
    const auto is_lit = [&](const Vector<double>& from, const Vector<double>& to) {
      const Vector<double> way = setting.place(to) - setting.place(from);
      const Ray<Real> ray{trial::rounded<Real>(setting.place(from)),
                          trial::rounded<Real>(glm::normalize(way))};
      Color<Real> light(constant<Real>(1), constant<Real>(1), constant<Real>(1));
      return reaches(built.frame, ray, constant<Real>(glm::length(way)), k_no_node, k_void,
                     built.area().crossings, light);
    };
    CAPTURE(i);
    REQUIRE_FALSE(is_lit(above, below));
    REQUIRE_FALSE(is_lit(below, above));
    REQUIRE(is_lit(below, beside));
    REQUIRE(is_lit(below + Vector<double>(0, 0, 0.2), below));
  }
}

TEMPLATE_TEST_CASE("A ray that leaves the outer side of a bowl does not meet it again", "", float,
                   double) {
  using Real = TestType;
  Random random(2403);
  for (int i = 0; i < 200; ++i) {
    const bool is_flat = random.coin();
    const Setting setting(random, is_flat ? 0 : random.uniform(0.05, 0.6));
    BuiltFrame<Real> built(setting.model, setting.root);
    for (int k = 0; k < 50; ++k) {
      // Of a flat one both sides are outer ones.
      const double side = is_flat && random.coin() ? 1 : -1;
      const Vector<double> from =
          setting.place(random.in_cube(0.8) + Vector<double>(0, 0, 2 * side));
      const Vector<double> to = setting.place(
          {random.uniform(-0.85, 0.85), random.uniform(-0.85, 0.85), random.uniform(0, 0.3)});
      const RayQuery<Real> query{
          {trial::rounded<Real>(from), trial::rounded<Real>(glm::normalize(to - from))},
          far_away<Real>(),
          false,
          0,
          0};
      const auto crossings = built.crossings_of(query);
      if (crossings.empty()) {
        continue;
      }
      const auto point = surface_point(built.frame, query, crossings[0], k_void);
      const Vector<double> leaving = random.direction_around(
          glm::normalize(trial::exact(point.normal)), random.magnitude(1e-6, 1));
      const RayQuery<Real> next{{departure(point), trial::rounded<Real>(leaving)},
                                far_away<Real>(),
                                false,
                                0,
                                0,
                                left_behind(point)};
      CAPTURE(i, k, is_flat);
      REQUIRE(built.crossings_of(next).empty());
    }
  }
}

TEMPLATE_TEST_CASE("Of a sheet in a CSG tree what the operators leave is seen", "", float, double) {
  Random random(2404);
  for (int i = 0; i < 300; ++i) {
    Model model;
    const Placement placement = random.placement(random.in_cube(4), random.magnitude(1e-2, 1e2), 1);
    const SurfaceIndex other = model.add(trial::matt_surface());
    const NodeIndex sheet = add_bowl(model, either(random), 0, placement);
    const NodeIndex box = model.add(kind_of<box::Kind>,
                                    concatenate(placement, trial::scaled({0.4, 0.4, 0.4})), other);
    const auto crossings = [&](BooleanOperator combination, NodeIndex a, NodeIndex b, double x) {
      Model combined = model;
      const NodeIndex root = combined.combine(combination, a, b);
      BuiltFrame<TestType> built(combined, root);
      const Vector<double> from = transform_point(placement, {x, 0.11, 3});
      const Vector<double> to = transform_point(placement, {x, 0.12, 0});
      return built.crossings_of(from, glm::normalize(to - from));
    };
    const double inside = random.uniform(-0.38, 0.38);
    const double outside = random.uniform(0.42, 0.88);
    CAPTURE(i, inside, outside);
    using Operator = BooleanOperator;
    REQUIRE(crossings(Operator::difference, sheet, box, inside).empty());
    REQUIRE(crossings(Operator::difference, sheet, box, outside).size() == 2);
    REQUIRE(crossings(Operator::intersection, sheet, box, inside).size() == 2);
    REQUIRE(crossings(Operator::intersection, sheet, box, outside).empty());
    REQUIRE(crossings(Operator::union_of, sheet, box, outside).size() == 2);
    const auto both = crossings(Operator::union_of, sheet, box, inside);
    REQUIRE(both.size() >= 2);
    REQUIRE(both.front().medium == other);
    const auto carved = crossings(Operator::difference, box, sheet, inside);
    REQUIRE(carved.front().medium == other);
    REQUIRE(carved.back().medium == k_void);
    REQUIRE(carved.front().distance < carved.back().distance);
  }
}

TEMPLATE_TEST_CASE("Turned, moved and scaled, a sheet is met at the same places of it", "", float,
                   double) {
  Random random(2405);
  const double tolerance = 2000 * static_cast<double>(ulps<TestType>(1));
  for (int i = 0; i < 300; ++i) {
    const Sheet sheet = either(random);
    const double bend = random.uniform(0.1, 0.5);
    const double scale = random.magnitude(1e-2, 1e2);
    const Placement placement = random.placement(random.in_cube(scale), scale, 1);
    const Vector<double> from = random.in_cube(0.4) + Vector<double>(0, 0, random.coin() ? 3 : -3);
    const Vector<double> to = random.in_cube(0.3);
    const auto met = [&](const Placement& place) {
      Model model;
      const NodeIndex root = add_bowl(model, sheet, bend, place);
      BuiltFrame<TestType> built(model, root);
      const Vector<double> start = transform_point(place, from);
      const Vector<double> way = transform_point(place, to) - start;
      return std::pair{built.crossings_of(start, glm::normalize(way)), glm::length(way)};
    };
    const auto [own, own_length] = met(trial::unmoved());
    const auto [placed, placed_length] = met(placement);
    CAPTURE(i, scale);
    REQUIRE(own.size() == 2);
    REQUIRE(placed.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      REQUIRE(own[k].face == placed[k].face);
      REQUIRE(static_cast<double>(own[k].distance) / own_length ==
              Approx(static_cast<double>(placed[k].distance) / placed_length).margin(tolerance));
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
