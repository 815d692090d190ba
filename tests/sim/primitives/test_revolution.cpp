#include "sim/primitives/revolution.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/primitives/generatrix_curve.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;
namespace revolution = firmware::revolution;

/// A vase, of which a displacement swells the middle.
RevolutionShape vase(double amount) {
  RevolutionShape shape;
  Displacement swell{"swell", {}, amount};
  for (int i = 0; i < 12; ++i) {
    shape.points.emplace_back(1 + 0.3 * std::sin(i), 0.5 * i);
    swell.by.emplace_back(i == 5 || i == 6 ? 1 : 0, i == 6 ? 0.2 : 0);
  }
  shape.displacements.push_back(swell);
  return shape;
}

/// The points (r, z) of the converted sections in the object's frame.
std::vector<glm::dvec2> placed_sections(const LocalFrame& frame) {
  const revolution::Generatrix<double> curve = revolution::generatrix(frame.parameters.data());
  std::vector<glm::dvec2> points;
  for (int i = 0; i <= 3 * curve.sections; ++i) {
    const double* point = curve.points + 2 * i;
    points.emplace_back(point[0] * frame.to_object[0].x,
                        point[1] * frame.to_object[2].z + frame.to_object[3].z);
  }
  return points;
}

bool is_near(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  bool near = a.size() == b.size();
  for (std::size_t i = 0; near && i < a.size(); ++i) {
    near = glm::length(a[i] - b[i]) < 1e-9;
  }
  return near;
}

std::vector<std::size_t> differences(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] != b[i]) {
      places.push_back(i);
    }
  }
  return places;
}

std::string scene_with(const std::string& points, const std::string& more) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}}\n"
         "object: {surface: red, revolution: {points: [" +
         points + "]" + more + "}}\n";
}

}  // namespace

TEST_CASE("A board is told nothing else anew than the coordinates that a displacement moves") {
  const LocalFrame still = frame_of(vase(0));
  for (const double amount : {0.01, -0.4}) {
    const LocalFrame moved = frame_of(vase(amount));
    CHECK(moved.to_object == still.to_object);
    // Behind a header of four, r of the points 5 and 6, and z of the latter.
    CHECK(differences(moved.given, still.given) == std::vector<std::size_t>{14, 16, 17});
  }
  // Larger than at rest, it has twice the unit.
  const LocalFrame swollen = frame_of(vase(0.8));
  CHECK(swollen.to_object[0].x == 2 * still.to_object[0].x);
  CHECK(differences(frame_of(vase(1)).given, swollen.given) ==
        std::vector<std::size_t>{14, 16, 17});
}

TEST_CASE("The sections are the displaced ones in whichever frame, within its unit") {
  Random random(5101);
  for (int i = 0; i < 300; ++i) {
    RevolutionShape shape = vase(random.uniform(-0.5, 0.5) * random.magnitude(0.1, 100));
    shape.displacements.front().by[8].y = random.coin() ? 0 : random.uniform(-2, 2);
    const GeneratrixCurve curve = generatrix_curve(shape);
    const LocalFrame frame = frame_of(shape);
    std::vector<glm::dvec2> expected = curve.points;
    if (enclosed_area(curve) < 0) {
      std::reverse(expected.begin(), expected.end());
    }
    CAPTURE(i, shape.displacements.front().amount);
    CHECK(is_near(placed_sections(frame), expected));
    firmware::Box<double> box{};
    REQUIRE(revolution::bounds(frame.parameters.data(), box));
    CHECK(box.high.x <= 1 + 1e-9);
    CHECK(box.high.x > 0.5 - 1e-9);
    CHECK(std::fmax(box.high.z, -box.low.z) <= 1 + 1e-9);
    CHECK(std::fmax(box.high.z, -box.low.z) > 0.5 - 1e-9);
  }
}

TEST_CASE("Closed sections may be given either way round") {
  RevolutionShape ring;
  ring.curve = GeneratrixKind::bezier;
  ring.closed = true;
  ring.points = {{3, 0}, {3, 1}, {2, 1.5}, {1.5, 1}, {1, 0.5}, {2, -1}};
  RevolutionShape turned = ring;
  turned.points = {{3, 0}, {2, -1}, {1, 0.5}, {1.5, 1}, {2, 1.5}, {3, 1}};
  CHECK(enclosed_area(generatrix_curve(ring)) == Approx(-enclosed_area(generatrix_curve(turned))));
  CHECK(is_near(placed_sections(frame_of(ring)), placed_sections(frame_of(turned))));
}

TEST_CASE("A generatrix may have hundreds of points") {
  std::string points;
  std::string ring;
  for (int i = 0; i < 400; ++i) {
    const double turn = 6.283185307179586 * i / 400;
    points += (i > 0 ? ", [" : "[") + std::to_string(1 + 0.3 * std::sin(0.2 * i)) + ", " +
              std::to_string(0.01 * i) + "]";
    ring += (i > 0 ? ", [" : "[") + std::to_string(2 + std::cos(turn)) + ", " +
            std::to_string(std::sin(turn)) + "]";
  }
  for (const std::string curve : {"", ", curve: interpolating", ", curve: polygon"}) {
    CHECK(error_of(scene_with(points, curve)).empty());
    CHECK(error_of(scene_with(ring, curve + ", closed: true")).empty());
  }
}

}  // namespace maquette::sim
