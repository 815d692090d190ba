#include "sim/primitives/generatrix_curve.hpp"

#include <algorithm>

#include "firmware/primitives/revolution.hpp"
#include "sim/primitives/revolution.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

/// A profile that does not cross itself, upwards beside the axis.
RevolutionShape random_profile(Random& random) {
  RevolutionShape shape;
  const int count = 4 + random.below(12);
  for (int i = 0; i < count; ++i) {
    shape.points.emplace_back(random.uniform(0.2, 2), i + random.uniform(0, 0.4));
  }
  return shape;
}

glm::dvec2 shift_of(Random& random) {
  return {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
}

}  // namespace

TEST_CASE("Displacements add up, each times its amount") {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    RevolutionShape shape = random_profile(random);
    for (const double amount : {0.25, -2.0}) {
      Displacement displacement{"d", {}, amount};
      for (std::size_t k = 0; k < shape.points.size(); ++k) {
        displacement.by.push_back(shift_of(random));
      }
      shape.displacements.push_back(displacement);
    }
    const std::vector<glm::dvec2> moved = displaced_points(shape);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const glm::dvec2 expected = shape.points[k] + 0.25 * shape.displacements[0].by[k] -
                                  2.0 * shape.displacements[1].by[k];
      CHECK(moved[k].x == Approx(expected.x));
      CHECK(moved[k].y == Approx(expected.y));
    }
    RevolutionShape written = shape;
    written.points = moved;
    written.displacements.clear();
    CHECK(generatrix_curve(written).points == generatrix_curve(shape).points);
  }
}

TEST_CASE("A straight generatrix encloses its radius times its height") {
  RevolutionShape shape;
  for (int i = 0; i < 9; ++i) {
    shape.points.emplace_back(0.75, 0.5 * i);
  }
  const GeneratrixCurve curve = generatrix_curve(shape);
  CHECK(enclosed_area(curve) == Approx(0.75 * 3));
  CHECK(extent_of(curve).low.y == Approx(0.5));
  CHECK(extent_of(curve).high.y == Approx(3.5));
}

TEST_CASE("The way along the generatrix is free") {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    RevolutionShape shape = random_profile(random);
    RevolutionShape reversed = shape;
    std::reverse(reversed.points.begin(), reversed.points.end());
    CHECK(enclosed_area(generatrix_curve(reversed)) ==
          Approx(-enclosed_area(generatrix_curve(shape))));
    CHECK(frame_of(reversed).parameters == frame_of(shape).parameters);
  }
}

TEST_CASE("The local frame has radius 1 and heights from -1 to 1") {
  Random random(13);
  for (int i = 0; i < 200; ++i) {
    const RevolutionShape shape = random_profile(random);
    const LocalFrame frame = frame_of(shape);
    firmware::Box<double> box{};
    REQUIRE(firmware::revolution::bounds(frame.parameters.data(), box));
    CHECK(box.high.x == Approx(1));
    CHECK(box.low.z == Approx(-1));
    CHECK(box.high.z == Approx(1));
    const Extent2 extent = extent_of(generatrix_curve(shape));
    CHECK(frame.to_object[0].x == Approx(extent.high.x));
    CHECK(frame.to_object[3].z + frame.to_object[2].z == Approx(extent.high.y));
  }
}

TEST_CASE("A generatrix that crosses itself is told from one that does not") {
  Random random(14);
  for (int i = 0; i < 200; ++i) {
    RevolutionShape shape = random_profile(random);
    CHECK_FALSE(own_crossing(generatrix_curve(shape)));
  }
  RevolutionShape loop;
  loop.points = {{1, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 3}, {2, 1}, {0.2, 1}, {0.2, 0.9}};
  const auto crossing = own_crossing(generatrix_curve(loop));
  REQUIRE(crossing);
  CHECK(crossing->first < crossing->second);
}

TEST_CASE("A generatrix that makes no solid is refused with the reason") {
  const auto error = [](const std::string& revolution) {
    return error_of(
        "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
        "surfaces: {red: {diffuse: 0.5}}\n"
        "object:\n  surface: red\n  revolution:\n    " +
        revolution + "\n");
  };
  const auto check = [&error](const std::string& revolution, const std::string& expected) {
    const std::string message = error(revolution);
    INFO(message);
    CHECK(message.find("scene.yaml:6:") == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  CHECK(error("points: [[1, 0], [1, 1], [1, 2], [1, 3]]").empty());
  CHECK(error("{points: [[1, 0], [2, 0], [1.5, 1]], closed: true}").empty());
  CHECK(error("points: [[-1, 0], [0, 0], [1, 0], [1, 1], [0, 2], [-1, 2]]").empty());
  check("closed: true", "`points` is missing");
  check("points: [[1, 0], [1, 1], [1, 2]]", "3 control points; 4 to 65539 are allowed");
  check("{points: [[1, 0], [1, 1]], closed: true}", "2 control points; 3 to 65536 are allowed");
  check("points: [[1, 0], [1, 1], [1, 2], [1, 3, 4]]", "a list of two numbers is allowed");
  check("points: [[1, 0], [1, 1], [1, .nan], [1, 3]]", "points: ");
  check("points: [[1, 0], [-1, 1], [-1, 2], [1, 3]]", "leaves the half-plane r >= 0");
  check("points: [[0, 0], [0, 1], [0, 2], [0, 3]]", "encloses nothing");
  check("points: [[1, 2], [2, 2], [3, 2], [4, 2]]", "encloses nothing");
  check("points: [[1, 0], [1, 1], [1, 2], [1, 3], [2, 4], [3, 3], [2, 1], [0.2, 1], [0.2, 0.9]]",
        "crosses itself");
  check("{points: [[1, 0], [1, 1], [1, 2], [1, 3]], displacements: {swell: {by: [[1, 0]]}}}",
        "1 shifts for 4 control points");
  check("{points: [[1, 0], [1, 1], [1, 2], [1, 3]], displacements: {swell: {amount: 1}}}",
        "`by` is missing");
  check(
      "{points: [[1, 0], [1, 1], [1, 2], [1, 3]], displacements: {in: {amount: 2, by: [[-1, 0], "
      "[-1, 0], [-1, 0], [-1, 0]]}}}",
      "the generatrix, displaced, leaves the half-plane");
}

}  // namespace maquette::sim
