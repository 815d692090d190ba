#include "firmware/synthesize.hpp"

#include <memory>

#include "tests/catch.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;

/// A bright half-space below the plane x = edge at a depth of 10, as flat as a picture.
struct Edge {
  explicit Edge(double edge) {
    model.ambient = {1, 1, 1};
    model.needs.lights = false;
    const trial::Placement wall = concatenate(trial::moved({0, 0, 11}), trial::scaled({50, 50, 1}));
    const NodeIndex box = model.add(kind_of<box::Kind>, wall);
    // The edge is that of a body cut off at x = edge.
    const NodeIndex cut = model.add(
        kind_of<half_space::Kind>,
        concatenate(trial::moved({edge, 0, 0}), trial::turned({0, 1, 0}, elementary::k_pi / 2)));
    built = std::make_unique<BuiltFrame<double>>(
        model, model.combine(BooleanOperator::intersection, box, cut));
  }

  Pixel pixel(std::int16_t column, std::int32_t per_side, double contrast = 0) {
    built->frame.database.samples = {per_side, contrast};
    built->frame.database.needs.samples = per_side > 1;
    return built->pixel(column, 20);
  }

  Model model;
  std::unique_ptr<BuiltFrame<double>> built;
};

/// The pixel's share in front of x = edge at depth 10, of which the bright side is below.
double bright_share(double edge, int column) {
  const double step = 1.0 / 48;
  const double left = (column - 31.5 - 0.5) * step * 10;
  return smaller(1.0, larger(0.0, (edge - left) / (step * 10)));
}

TEST_CASE("A pixel across an edge is the mean of its rays") {
  trial::Random random(1401);
  for (int i = 0; i < 200; ++i) {
    const double edge = random.uniform(0.1, 5);
    Edge scene(edge);
    const auto column = static_cast<std::int16_t>(31.5 + edge / 10 * 48 + 0.5);
    for (const std::int32_t per_side : {2, 3, 4, 8}) {
      const Pixel pixel = scene.pixel(column, per_side);
      CHECK(pixel.rays.primary == per_side * per_side);
      const double value = (pixel.rgb & 0xFF) / 255.0;
      CHECK(value == Approx(bright_share(edge, column)).margin(0.51 / per_side + 0.003));
    }
  }
}

TEST_CASE("Away from an edge any number of rays gives the same pixel") {
  Edge scene(0.3);
  for (std::int16_t column = 0; column < 64; ++column) {
    const double share = bright_share(0.3, column);
    if (share == 0 || share == 1) {
      CHECK(scene.pixel(column, 1).rgb == scene.pixel(column, 5).rgb);
    }
  }
}

TEST_CASE("By contrast, only pixels whose corners differ get all rays, and those the same ones") {
  Edge scene(0.3);
  int refined = 0;
  for (std::int16_t column = 0; column < 64; ++column) {
    const Pixel all = scene.pixel(column, 4);
    const Pixel some = scene.pixel(column, 4, 0.05);
    const bool corners_differ =
        bright_share(0.3, column) > 0.125 && bright_share(0.3, column) < 0.875;
    CAPTURE(column);
    CHECK(some.rays.primary == (corners_differ ? 16 : 4));
    if (corners_differ) {
      CHECK(some.rgb == all.rgb);
      ++refined;
    }
  }
  CHECK(refined == 1);
  // A contrast that nothing exceeds refines nothing.
  for (std::int16_t column = 0; column < 64; ++column) {
    CHECK(scene.pixel(column, 4, 1).rays.primary == 4);
  }
}

TEST_CASE("A light brighter than white does not outweigh the rays beside it") {
  CHECK(displayable(Color<double>(5, 0.5, -1)) == Color<double>(1, 0.5, 0));
}

TEST_CASE("The depth of a pixel is that of the nearest of its rays") {
  Edge scene(0.3);
  scene.built->frame.database.needs.depth = true;
  scene.built->frame.prepared.depths = {0, 100};
  for (std::int16_t column = 0; column < 64; ++column) {
    const double share = bright_share(0.3, column);
    if (share > 0.3) {
      CHECK(scene.pixel(column, 4).depth == depth_code(scene.built->frame.prepared.depths, 10.0));
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
