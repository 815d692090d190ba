#include "sim/primitives/generatrix_sections.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;
using Points = std::vector<glm::dvec2>;

Points random_points(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
  }
  return points;
}

/// The slope at an end of a section, times a third of its parameter's range.
glm::dvec2 slope(const Points& bezier, std::size_t section, bool at_end) {
  const glm::dvec2* p = &bezier[3 * section];
  return at_end ? p[3] - p[2] : p[1] - p[0];
}

/// The second derivative likewise.
glm::dvec2 bend(const Points& bezier, std::size_t section, bool at_end) {
  const glm::dvec2* p = &bezier[3 * section];
  return at_end ? p[3] - 2.0 * p[2] + p[1] : p[2] - 2.0 * p[1] + p[0];
}

bool near(const glm::dvec2& a, const glm::dvec2& b) { return glm::length(a - b) < 1e-12; }

std::string scene_with(const std::string& revolution) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}}\n"
         "object:\n  surface: red\n  revolution:\n    " +
         revolution + "\n";
}

}  // namespace

TEST_CASE("An interpolating spline passes its points, as smooth as a B-spline") {
  Random random(4301);
  for (int i = 0; i < 300; ++i) {
    const bool closed = random.coin();
    const Points points = random_points(random, 3 + random.below(20));
    const Points bezier = sections_of(points, GeneratrixKind::interpolating, closed);
    const std::size_t sections = points.size() - (closed ? 0 : 1);
    REQUIRE(bezier.size() == 3 * sections + 1);
    for (std::size_t k = 0; k <= sections; ++k) {
      REQUIRE(near(bezier[3 * k], points[k % points.size()]));
    }
    for (std::size_t k = 0; k < sections; ++k) {
      const std::size_t next = (k + 1) % sections;
      if (closed || next > 0) {
        REQUIRE(near(slope(bezier, k, true), slope(bezier, next, false)));
        REQUIRE(near(bend(bezier, k, true), bend(bezier, next, false)));
      }
    }
    if (!closed) {
      REQUIRE(near(bend(bezier, 0, false), {0, 0}));
      REQUIRE(near(bend(bezier, sections - 1, true), {0, 0}));
    }
  }
}

TEST_CASE("A polygon's sections run straight and evenly from corner to corner") {
  Random random(4302);
  for (int i = 0; i < 100; ++i) {
    const bool closed = random.coin();
    const Points points = random_points(random, 3 + random.below(20));
    const Points bezier = sections_of(points, GeneratrixKind::polygon, closed);
    for (std::size_t k = 0; k + 1 < bezier.size(); ++k) {
      const std::size_t corner = k / 3;
      const glm::dvec2 end = points[(corner + 1) % points.size()];
      const double share = static_cast<double>(k % 3) / 3;
      REQUIRE(near(bezier[k], points[corner] * (1 - share) + end * share));
    }
  }
}

TEST_CASE("Bezier sections are taken as they are, and every kind moves with its points") {
  Random random(4303);
  const Points points = random_points(random, 12);
  Points expected = points;
  expected.push_back(points.front());
  CHECK(sections_of(points, GeneratrixKind::bezier, true) == expected);
  for (const auto kind : {GeneratrixKind::b_spline, GeneratrixKind::bezier,
                          GeneratrixKind::interpolating, GeneratrixKind::polygon}) {
    const glm::dvec2 scale(0.3, 2);
    const glm::dvec2 shift(0, -1.5);
    Points moved = points;
    for (glm::dvec2& point : moved) {
      point = point * scale + shift;
    }
    const Points before = sections_of(points, kind, true);
    const Points after = sections_of(moved, kind, true);
    REQUIRE(before.size() == after.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      CHECK(near(after[k], before[k] * scale + shift));
    }
  }
}

TEST_CASE("Numbers of points that make no sections are answered with those allowed") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(
      error_of(scene_with("{points: [[1, 0], [1, 1], [1, 2]], curve: bezier}")),
      ContainsSubstring("scene.yaml:6:14: points: 3 control points; 4 to 196609 are allowed for "
                        "an open generatrix, three for each section and the last"));
  CHECK_THAT(error_of(scene_with("{points: [[1, 0]], curve: polygon}")),
             ContainsSubstring("points: 1 control points; 2 to 65537 are allowed"));
  CHECK_THAT(error_of(scene_with("{points: [[1, 0], [1, 1]], curve: interpolating, closed: true}")),
             ContainsSubstring(
                 "points: 2 control points; 3 to 65536 are allowed for a closed generatrix"));
  CHECK_THAT(error_of(scene_with("{points: [[1, 0], [1, 1]], curve: cubic}")),
             ContainsSubstring("b_spline, bezier, interpolating, polygon"));
  CHECK(error_of(scene_with("{points: [[1, 0], [1, 1]], curve: polygon}")).empty());
}

}  // namespace maquette::sim
