#include "firmware/depth.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/test_frame.hpp"

using namespace maquette::firmware;
using trial::BuiltFrame;
using trial::Model;
using trial::Random;

namespace {

Model model_with_depth() {
  Model model;
  model.needs.depth = true;
  return model;
}

/// Where the ray through a pixel, which gains 1 in depth per unit of distance, enters a sphere.
double depth_of_sphere(const Observer<double>& observer, int column, int row,
                       const Vector<double>& center, double radius) {
  const Vector<double> d(observer.left + column * observer.step, observer.top - row * observer.step,
                         1);
  const double b = glm::dot(d, center) / glm::dot(d, d);
  const double under = b * b - (glm::dot(center, center) - radius * radius) / glm::dot(d, d);
  return under > 0 ? b - std::sqrt(under) : far_away<double>();
}

}  // namespace

TEST_CASE("The depth of a pixel is that of the nearest sphere, whatever shines or refracts there") {
  Random random(71);
  for (int i = 0; i < 60; ++i) {
    Model model = model_with_depth();
    model.lights.push_back({random.in_cube(20), {9, 9, 9}});
    const SurfaceIndex glass = model.add(trial::glass_surface(1.5));
    const Vector<double> centers[2] = {Vector<double>(0, 0, 12) + random.in_cube(3),
                                       Vector<double>(0, 0, 16) + random.in_cube(3)};
    const double radii[2] = {random.uniform(0.5, 2), random.uniform(0.5, 2)};
    NodeIndex children[2];
    for (int k = 0; k < 2; ++k) {
      const auto place = concatenate(trial::moved(centers[k]),
                                     trial::scaled(Vector<double>(radii[k], radii[k], radii[k])));
      children[k] = model.add(kind_of<sphere::Kind>, place, k == 0 && random.coin() ? glass : 0);
    }
    BuiltFrame<double> built(model,
                             model.combine(BooleanOperator::union_of, children[0], children[1]));
    const DepthRange<double>& range = built.frame.prepared.depths;
    REQUIRE(range.low <= centers[0].z - radii[0]);
    REQUIRE(range.low + k_full_depth / range.codes_per_unit >= centers[1].z + radii[1]);
    for (std::int16_t row = 0; row < model.rows; row = static_cast<std::int16_t>(row + 3)) {
      for (std::int16_t column = 0; column < model.columns; ++column) {
        const Observer<double>& observer = built.frame.database.observer;
        const double nearest =
            std::min(depth_of_sphere(observer, column, row, centers[0], radii[0]),
                     depth_of_sphere(observer, column, row, centers[1], radii[1]));
        const int code = built.pixel(column, row).depth;
        if (nearest == far_away<double>()) {
          REQUIRE(code == k_full_depth);
        } else {
          REQUIRE(std::fabs(code - (nearest - range.low) * range.codes_per_unit) <= 1 + 1e-6);
        }
      }
    }
  }
}

TEST_CASE("Depths use the whole range of codes, and endless matter has them too") {
  Model model = model_with_depth();
  const auto place = concatenate(trial::moved({0, 0, 10}), trial::scaled({4, 4, 4}));
  BuiltFrame<double> ball(model, model.add(kind_of<sphere::Kind>, place));
  CHECK(ball.pixel(32, 24).depth < 100);

  Model wall = model_with_depth();
  wall.from_screen = trial::moved({0, 0, -10});
  BuiltFrame<double> endless(
      wall, wall.add(kind_of<half_space::Kind>, trial::turned({1, 0, 0}, std::acos(-1.0))));
  const int code = endless.pixel(32, 24).depth;
  CHECK(code > 0);
  CHECK(code <= k_full_depth);
}

TEST_CASE("Without a need for it no depth is computed and nothing is charged for it") {
  Model model;
  const auto place = concatenate(trial::moved({0, 0, 10}), trial::scaled({4, 4, 4}));
  const NodeIndex root = model.add(kind_of<sphere::Kind>, place);
  BuiltFrame<float> without(model, root);
  CHECK(without.pixel(32, 24).depth == 0);
  model.needs.depth = true;
  BuiltFrame<float> with(model, root);
  CHECK(with.pixel(0, 0).depth == k_full_depth);
  CHECK(with.pixel(32, 24).rgb == without.pixel(32, 24).rgb);
}
