#include "sim/primitives/patch_nets.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/primitives/patches.hpp"
#include "sim/primitives/patches.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

/// A closed spline surface around a ring of radius 2, some units off the origin.
PatchesShape ring(Random& random, int rows, int columns) {
  const double turn = 2 * std::acos(-1.0);
  PatchesShape shape;
  shape.basis = PatchBasis::b_spline;
  shape.solid = true;
  shape.grid = PatchGrid{columns, true, true};
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const double radius = 2 + 0.5 * std::cos(turn * k / columns);
      shape.points.emplace_back(radius * std::cos(turn * i / rows) + 30,
                                radius * std::sin(turn * i / rows) - 7,
                                0.5 * std::sin(turn * k / columns) + random.uniform(-0.1, 0.1));
    }
  }
  return shape;
}

/// A closed surface whose ends are poles on the axis, as in scenes/primitives/patches.yaml.
PatchesShape drop(int columns) {
  const double turn = 2 * std::acos(-1.0);
  const double rows[7][2] = {{-1, 0.2},  {0, 0}, {1, 0.2},   {1.3, 1},
                             {0.7, 1.8}, {0, 2}, {-0.7, 1.8}};
  PatchesShape shape;
  shape.basis = PatchBasis::b_spline;
  shape.solid = true;
  shape.grid = PatchGrid{columns, true, false};
  for (const auto& row : rows) {
    for (int k = 0; k < columns; ++k) {
      shape.points.emplace_back(row[0] * std::cos(turn * k / columns),
                                row[0] * std::sin(turn * k / columns), row[1]);
    }
  }
  return shape;
}

}  // namespace

TEST_CASE("A closed spline surface has a neighbour at every edge") {
  Random random(31);
  for (int rows = 3; rows < 8; ++rows) {
    const PatchesShape shape = ring(random, rows, 10 - rows);
    const std::vector<PatchNet> nets = patch_nets(shape);
    CHECK(nets.size() == static_cast<std::size_t>(rows * (10 - rows)));
    CHECK_FALSE(open_patch(nets));
  }
  for (int columns = 4; columns < 12; columns += 2) {
    CHECK_FALSE(open_patch(patch_nets(drop(columns))));
  }
}

TEST_CASE("A set that lacks a patch or has one twice or the wrong way round is open") {
  Random random(32);
  for (int i = 0; i < 50; ++i) {
    const std::vector<PatchNet> nets = patch_nets(ring(random, 4, 4));
    const auto chosen = static_cast<std::size_t>(random.below(16));
    std::vector<PatchNet> without = nets;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(chosen));
    CHECK(open_patch(without));
    std::vector<PatchNet> twice = nets;
    twice.push_back(nets[chosen]);
    CHECK(open_patch(twice));
    std::vector<PatchNet> turned = nets;
    std::swap(turned[chosen][0], turned[chosen][3]);
    CHECK(open_patch(turned));
  }
}

TEST_CASE("A grid of Bezier points is the patches that share its points") {
  PatchesShape shape;
  for (int i = 0; i < 7 * 4; ++i) {
    shape.points.emplace_back(i / 4, i % 4, i * i % 5);
  }
  shape.grid = PatchGrid{4, false, false};
  const std::vector<PatchIndices> indices = patch_indices(shape);
  REQUIRE(indices.size() == 2);
  for (int i = 0; i < 16; ++i) {
    CHECK(indices[0][static_cast<std::size_t>(i)] == i);
    CHECK(indices[1][static_cast<std::size_t>(i)] == 12 + i);
  }
  PatchesShape listed = shape;
  listed.patches = indices;
  listed.grid.reset();
  CHECK(patch_nets(listed) == patch_nets(shape));
}

TEST_CASE("The volume of a solid is that of a box, whose points may be anywhere on its sides") {
  // Six bilinear sides by their corners; u x v points outwards.
  const int sides[6][4] = {{0, 2, 4, 6}, {1, 5, 3, 7}, {0, 4, 1, 5},
                           {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 6, 5, 7}};
  const glm::dvec3 edges(2, 3, 0.5);
  std::vector<PatchNet> nets;
  for (const auto& side : sides) {
    PatchNet& net = nets.emplace_back();
    const auto corner = [&](int n) {
      return glm::dvec3(n & 1, (n >> 1) & 1, n >> 2) * edges + glm::dvec3(5, -3, 1);
    };
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) {
        const double u = i / 3.0;
        const double v = k / 3.0;
        net[static_cast<std::size_t>(4 * i + k)] =
            (1 - u) * ((1 - v) * corner(side[0]) + v * corner(side[1])) +
            u * ((1 - v) * corner(side[2]) + v * corner(side[3]));
      }
    }
  }
  CHECK(std::fabs(enclosed_volume(nets)) == Approx(3).epsilon(1e-12));
}

TEST_CASE("The local frame holds the points in [-1, 1], with normals outwards") {
  Random random(33);
  for (int i = 0; i < 20; ++i) {
    PatchesShape shape = ring(random, 4, 4);
    if (i % 2 == 1) {
      std::reverse(shape.points.begin(), shape.points.end());
    }
    if (i % 4 == 3) {
      for (glm::dvec3& point : shape.points) {
        point.x = -point.x;
      }
    }
    const LocalFrame frame = frame_of(shape);
    namespace patches = firmware::patches;
    const auto set = patches::patch_set(frame.parameters.data());
    CHECK(set.is_solid);
    std::vector<PatchNet> nets(static_cast<std::size_t>(set.patches));
    double largest = 0;
    for (int n = 0; n < set.patches; ++n) {
      for (int k = 0; k < patches::k_net_points; ++k) {
        const double* point = set.patch(n) + k * patches::k_point_reals;
        nets[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)] = {point[0], point[1],
                                                                          point[2]};
        largest = std::fmax(largest, glm::length(glm::dvec3(point[0], point[1], 0)));
      }
    }
    CHECK(enclosed_volume(nets) > 0);
    CHECK_FALSE(open_patch(nets));
    const Extent3 extent = extent_of(nets);
    CHECK(std::fmax(extent.high.x, -extent.low.x) <= 1);
    CHECK(extent.high.x - extent.low.x > 0.8);
    CHECK(largest < 1.5);
    const Extent3 described = extent_of(patch_nets(shape));
    CHECK(frame.to_object[3].x + frame.to_object[0].x * extent.high.x == Approx(described.high.x));
    CHECK(frame.to_object[3].y + frame.to_object[1].y * extent.high.y == Approx(described.high.y));
  }
}

TEST_CASE("Patches that make no set are refused with the reason") {
  const std::string points =
      "points: [[0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0], [1, 0, 0], [1, 1, 1], [1, 2, 1], "
      "[1, 3, 0], [2, 0, 0], [2, 1, 1], [2, 2, 1], [2, 3, 0], [3, 0, 0], [3, 1, 0], [3, 2, 0], "
      "[3, 3, 0]]";
  const std::string all = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]";
  const auto error = [](const std::string& patches, const std::string& surface = "red") {
    return error_of(
        "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
        "surfaces: {red: {diffuse: 0.5}, glass: {transparent: true}}\n"
        "object:\n  surface: " +
        surface + "\n  patches:\n    {" + patches + "}\n");
  };
  const auto check = [&error](const std::string& patches, const std::string& expected,
                              const std::string& surface = "red") {
    const std::string message = error(patches, surface);
    INFO(message);
    CHECK(message.find("scene.yaml:") == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  CHECK(error(points + ", patches: [" + all + "]").empty());
  CHECK(error(points + ", grid: {columns: 4}").empty());
  CHECK(error(points + ", basis: b_spline, method: roots, grid: {columns: 4, closed_rows: true}")
            .empty());
  check("patches: [" + all + "]", "`points` is missing");
  check(points, "one of patches, grid is allowed and needed");
  check(points + ", patches: [" + all + "], grid: {columns: 4}",
        "one of patches, grid is allowed and needed");
  check(points + ", patches: []", "a list of patches is allowed");
  check(points + ", patches: [[0, 1, 2]]", "3 numbers stand here; a list of 16");
  check(points + ", patches: [0]", "a list of 16 numbers of points is allowed");
  check(points + ", patches: [[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 16]]",
        "there is no point 16; 0 to 15 are allowed");
  check(points + ", patches: [[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, -1]]",
        "patches: ");
  check("points: [[0, 0]], grid: {columns: 4}", "points: ");
  check("points: [], grid: {columns: 4}", "a list of points");
  check(points + ", grid: {columns: 5}", "16 points do not make whole rows of 5");
  check(points + ", grid: {columns: 8}", "8 points in a row; 4, 7, 10, ... are allowed");
  check(points + ", basis: b_spline, grid: {columns: 8}", "2 points in a column; 4 or more");
  check("points: [[1, 2, 3]], patches: [[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]]",
        "all control points are one point");
  check(points + ", solid: true, patches: [" + all + "]", "patch 0 has an edge");
  check(points + ", solid: true, grid: {columns: 4}", "patch 0 has an edge");
  check(points + ", method: halves, grid: {columns: 4}", "subdivision, roots");
  check(points + ", grid: {columns: 4}", "`glass` is transparent", "glass");
  std::string many = all;
  for (int i = 1; i < 129; ++i) {
    many += ", " + all;
  }
  check(points + ", patches: [" + many + "]", "129 patches; 1 to 128 are allowed");
}

}  // namespace maquette::sim
