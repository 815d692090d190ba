#include "sim/primitives/prism_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "firmware/primitives/prism.hpp"
#include "sim/primitives/prism.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

const double k_turn = 2 * std::acos(-1.0);

Contour square(const glm::dvec2& middle, double half) {
  Contour contour;
  for (const glm::dvec2& corner :
       {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    contour.points.push_back(middle + half * corner);
  }
  return contour;
}

/// Around a middle, every `stride`-th of its points next.
Contour round_contour(Random& random, const glm::dvec2& middle, int stride) {
  const int count = 2 * stride + 1 + random.below(6);
  const bool is_reversed = random.coin();
  Contour contour;
  contour.curved = random.coin();
  for (int i = 0; i < count; ++i) {
    const double angle = (is_reversed ? -k_turn : k_turn) * i * stride / count;
    const double radius = random.uniform(0.4, 1);
    contour.points.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return contour;
}

PrismShape random_tangle(Random& random) {
  PrismShape shape;
  for (int i = random.below(3); i >= 0; --i) {
    shape.contours.push_back(
        round_contour(random, {random.uniform(-1, 1), random.uniform(-1, 1)}, 1 + random.below(2)));
  }
  return shape;
}

/// Even-odd filling of the contours as they are given, by fine chords.
bool is_filled(const PrismShape& shape, const glm::dvec2& p) {
  bool is_inside = false;
  for (const Contour& contour : shape.contours) {
    const auto count = contour.points.size();
    constexpr int k_chords = 100;
    const auto chord_point = [&](std::size_t i, int step) {
      const double u = static_cast<double>(step) / k_chords;
      const auto at = [&](std::size_t k) { return contour.points[(i + k) % count]; };
      if (!contour.curved) {
        return at(0) + u * (at(1) - at(0));
      }
      const double v = 1 - u;
      return (v * v * v * at(0) + (3 * u * u * u - 6 * u * u + 4) * at(1) +
              (-3 * u * u * u + 3 * u * u + 3 * u + 1) * at(2) + u * u * u * at(3)) /
             6.0;
    };
    for (std::size_t i = 0; i < count; ++i) {
      for (int step = 0; step < k_chords; ++step) {
        const glm::dvec2 a = chord_point(i, step);
        const glm::dvec2 b = chord_point(i, step + 1);
        const double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
        is_inside = is_inside != ((a.y > p.y) != (b.y > p.y) && p.x < x);
      }
    }
  }
  return is_inside;
}

}  // namespace

TEST_CASE("Every edge has the filled side on its left, also where contours cross") {
  Random random(21);
  int wrong = 0;
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const PrismShape shape = random_tangle(random);
    const PrismEdges edges = prism_edges(shape);
    for (const std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
      for (const Edge& edge : *list) {
        for (const double u : {0.1, 0.5, 0.9}) {
          const glm::dvec2 along = point_at(edge, u + 1e-3) - point_at(edge, u - 1e-3);
          const glm::dvec2 left = 1e-3 * glm::normalize(glm::dvec2(-along.y, along.x));
          const glm::dvec2 middle = point_at(edge, u);
          const bool on_left = is_filled(shape, middle + left);
          const bool on_right = is_filled(shape, middle - left);
          if (on_left != on_right) {
            ++checked;
            wrong += on_right ? 1 : 0;
          }
        }
      }
    }
  }
  CHECK(checked > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("A star that crosses itself is cut at its crossings and hollow in the middle") {
  PrismShape star;
  star.contours.emplace_back();
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * i * k_turn / 5;
    star.contours[0].points.emplace_back(std::cos(angle), std::sin(angle));
  }
  const PrismEdges edges = prism_edges(star);
  CHECK(edges.lines.size() == 15);
  // Five isosceles triangles on the sides of the pentagon inside.
  const double inner = std::cos(k_turn / 5) / std::cos(k_turn / 10);
  const double half_side = inner * std::sin(k_turn / 10);
  const double height = 1 - inner * std::cos(k_turn / 10);
  CHECK(enclosed_area(edges) == Approx(5 * half_side * height));
}

TEST_CASE("Edges get the same point where they meet") {
  Random random(22);
  for (int i = 0; i < 200; ++i) {
    const PrismEdges edges = prism_edges(random_tangle(random));
    std::vector<glm::dvec2> ends;
    for (const std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
      for (const Edge& edge : *list) {
        ends.push_back(edge.points[0]);
        ends.push_back(edge.points[3]);
      }
    }
    for (const glm::dvec2& end : ends) {
      CHECK(std::count(ends.begin(), ends.end(), end) % 2 == 0);
    }
  }
}

TEST_CASE("Crossings are found to the rounding of the edges") {
  const Edge level = straight_edge({-1, 0.25}, {3, 0.25});
  const Edge arch{{glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, 0)}, false};
  const auto found = crossings(arch, level);
  REQUIRE(found.size() == 2);
  for (const auto& [u, v] : found) {
    CHECK(point_at(arch, u).y == Approx(0.25).epsilon(1e-9));
    CHECK(point_at(arch, u).x == Approx(point_at(level, v).x).epsilon(1e-9));
  }
  CHECK(crossings(level, straight_edge({0, 0.3}, {1, 0.3})).empty());
  CHECK(crossings(level, straight_edge({0, 0.25}, {9, 0.25})).empty());
  CHECK(crossings(level, straight_edge({1, 0.25}, {1, 2})).size() == 1);
}

TEST_CASE("The area is that of the filled contours") {
  PrismShape frame;
  frame.contours = {square({5, 3}, 2), square({5.5, 3}, 1)};
  CHECK(enclosed_area(prism_edges(frame)) == Approx(16 - 4));
  PrismShape cross;
  cross.contours = {square({0, 0}, 1), square({1, 0}, 1)};
  CHECK(enclosed_area(prism_edges(cross)) == Approx(4));
  PrismShape disc;
  disc.contours.resize(1);
  disc.contours[0].curved = true;
  for (int i = 0; i < 40; ++i) {
    disc.contours[0].points.emplace_back(std::cos(k_turn * i / 40), std::sin(k_turn * i / 40));
  }
  CHECK(enclosed_area(prism_edges(disc)) == Approx(k_turn / 2).epsilon(0.01));
}

TEST_CASE("A prism's local frame is the cube around it") {
  Random random(23);
  for (int i = 0; i < 200; ++i) {
    PrismShape shape = random_tangle(random);
    shape.height = random.magnitude(1e-3, 1e3);
    const PrismEdges edges = prism_edges(shape);
    const PlaneBox expected = box_of(edges);
    const LocalFrame frame = frame_of(shape);
    firmware::Box<double> box{};
    REQUIRE(firmware::prism::bounds(frame.parameters.data(), box));
    CHECK(box.low.x == Approx(-1));
    CHECK(box.high.y == Approx(1));
    const Vector3 low = firmware::transform_point(frame.to_object, Vector3(-1, -1, -1));
    const Vector3 high = firmware::transform_point(frame.to_object, Vector3(1, 1, 1));
    CHECK(low.x == Approx(expected.low.x));
    CHECK(high.y == Approx(expected.high.y));
    CHECK(low.z == Approx(0).margin(1e-12));
    CHECK(high.z == Approx(shape.height));
  }
}

TEST_CASE("Contours that make no solid are refused with the reason") {
  const auto error = [](const std::string& prism) {
    return error_of(
        "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
        "surfaces: {red: {diffuse: 0.5}}\n"
        "object:\n  surface: red\n  prism:\n    " +
        prism + "\n");
  };
  const auto check = [&error](const std::string& prism, const std::string& expected) {
    const std::string message = error(prism);
    INFO(message);
    CHECK(message.find("scene.yaml:6:") == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  const auto points = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", std::cos(i * k_turn / count),
                          std::sin(i * k_turn / count));
    }
    return "[" + text + "]";
  };
  CHECK(error("{height: 1, contours: [polygon: " + points(254) + "]}").empty());
  CHECK(error("{height: 1, contours: [spline: " + points(84) + "]}").empty());
  check("{height: 1, contours: [{polygon: [[0, 0], [1, 0], [1, 1]], spline: " + points(3) + "}]}",
        "one of polygon, spline");
  check("contours: [polygon: [[0, 0], [1, 0], [1, 1]]]", "`height` is missing");
  check("height: 1", "`contours` is missing");
  check("{height: 0, contours: [polygon: [[0, 0], [1, 0], [1, 1]]]}", "height: ");
  check("{height: 1, contours: []}", "a list of contours is allowed");
  check("{height: 1, contours: [[0, 0], [1, 0], [1, 1]]}", "one of polygon, spline is allowed");
  check("{height: 1, contours: [circle: [[0, 0], [1, 0], [1, 1]]]}", "one of polygon, spline");
  check("{height: 1, contours: [polygon: [[0, 0], [1, 0]]]}", "2 points; three or more");
  check("{height: 1, contours: [polygon: [[0, 0], [1, 0], [1, .inf]]]}", "polygon: ");
  check("{height: 1, contours: [polygon: [[0, 0], [1, 1], [2, 2]]]}", "they enclose nothing");
  check("{height: 1, contours: [polygon: [[1, 1], [1, 1], [1, 1]]]}", "they enclose nothing");
  check("{height: 1, contours: [spline: [[1, 1], [1, 2], [1, 5]]]}", "they enclose nothing");
  check("{height: 1, contours: [polygon: " + points(255) + "]}",
        "255 crossings of a line are possible; up to 254");
  check("{height: 1, contours: [spline: " + points(85) + "]}",
        "255 crossings of a line are possible; up to 254");
  std::string comb;
  for (int i = 0; i < 100; ++i) {
    comb += fmt::format("[{}, {}], ", i * 0.1, i % 2);
  }
  check("{height: 1, contours: [polygon: [" + comb + "[11, 0.5], [-1, 0.6]]]}",
        "edges cut where they cross; up to 254");
}

}  // namespace maquette::sim
