#include "sim/primitives/shell.hpp"

#include <cmath>

#include "sim/primitives/primitive_description.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::string scene_with(const std::string& object) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}, glass: {transparent: true}}\n"
         "object:\n" +
         object;
}

const char* const k_shell = "shell: {points: [[1, 0], [1, 1], [1, 2], [1, 3]]}";

void check_error(const std::string& object, const std::string& place, const std::string& expected) {
  const std::string message = error_of(scene_with(object));
  INFO(object << message);
  CHECK(message.find(place) == 0);
  CHECK(message.find(expected) != std::string::npos);
}

}  // namespace

TEST_CASE("A shell has the frame, the points and the tolerance of the solid of its generatrix") {
  RevolutionShape generatrix;
  generatrix.points = {{1, 0}, {2, 1}, {1, 2}, {1, 3}, {2, 4}};
  const LocalFrame solid = frame_of(generatrix);
  const LocalFrame shell = frame_of(ShellShape{generatrix});
  CHECK(shell.kind != solid.kind);
  CHECK(shell.parameters == solid.parameters);
  CHECK(shell.given == solid.given);
  CHECK(shell.to_object == solid.to_object);
  const PrimitiveDescription& description = description_of<firmware::shell::Kind>();
  CHECK(shell.parameters.at(static_cast<std::size_t>(description.root_tolerance)) == 1);
}

TEST_CASE("A shell may enclose nothing and cross itself, but sweeps a surface") {
  const auto shell = [](const std::string& generatrix) {
    return "  surface: red\n  shell:\n    " + generatrix + "\n";
  };
  const auto is_allowed = [&](const std::string& generatrix) {
    const std::string error = error_of(scene_with(shell(generatrix)));
    INFO(generatrix << ": " << error);
    CHECK(error.empty());
  };
  is_allowed("points: [[1, 0], [1, 1], [1, 2], [1, 3]]");
  is_allowed("{points: [[1, 0], [2, 1], [1, 0]], curve: polygon}");
  is_allowed(
      "points: [[1, 0], [1, 1], [1, 2], [1, 3], [2, 4], [3, 3], [2, 1], [0.2, 1], [0.2, 0.9]]");
  is_allowed("{points: [[1, 0], [2, 0], [1.5, 1]], closed: true}");
  const auto check = [&](const std::string& generatrix, const std::string& expected) {
    check_error(shell(generatrix), "scene.yaml:6:", expected);
  };
  check("closed: true", "`points` is missing");
  check("points: [[1, 0], [1, 1], [1, 2]]", "3 control points; 4 to 65539 are allowed");
  check("points: [[1, 0], [-1, 1], [-1, 2], [1, 3]]", "leaves the half-plane r >= 0");
  check("points: [[1, 2], [2, 2], [3, 2], [4, 2]]", "some radius and some height are needed");
  check("points: [[0, 0], [0, 1], [0, 2], [0, 3]]", "some radius and some height are needed");
  check("{points: [[1, 0], [1, 1], [1, 2], [1, 3]], displacements: {swell: {by: [[1, 0]]}}}",
        "1 shifts for 4 control points");
}

TEST_CASE("What has no thickness is opaque") {
  const std::string shell = k_shell;
  check_error("  surface: glass\n  " + shell + "\n",
              "scene.yaml:4:", "`glass` is transparent, but a shell has no thickness");
  check_error("  surface: glass\n  union:\n    - " + shell + "\n    - sphere: {radius: 1}\n",
              "scene.yaml:6:", "`glass` is transparent, but a shell has no thickness");
}

TEST_CASE("What has no thickness is cut, but nothing is cut by it") {
  const std::string sphere = "    - sphere: {radius: 1}\n";
  const std::string patches =
      "    - patches:\n"
      "        grid: {columns: 4}\n"
      "        points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0],\n"
      "                 [0, 1, 0], [1, 1, 0], [2, 1, 0], [3, 1, 0],\n"
      "                 [0, 2, 0], [1, 2, 0], [2, 2, 0], [3, 2, 0],\n"
      "                 [0, 3, 0], [1, 3, 0], [2, 3, 0], [3, 3, 0]]\n";
  for (const std::string& sheet : {"    - " + std::string(k_shell) + "\n", patches}) {
    for (const std::string combination : {"union", "intersection", "difference"}) {
      const std::string object = "  surface: red\n  " + combination + ":\n";
      INFO(combination << sheet);
      CHECK(error_of(scene_with(object + sheet + sphere)).empty());
      if (combination == "union") {
        CHECK(error_of(scene_with(object + sphere + sheet)).empty());
      } else {
        check_error(object + sphere + sheet, "scene.yaml:7:", "without thickness it has no inside");
      }
    }
  }
  const std::string nested = std::string("      - ") + k_shell + "\n";
  check_error("  surface: red\n  difference:\n" + sphere +
                  "    - union:\n      - sphere: {radius: 1}\n" + nested,
              "scene.yaml:9:", "without thickness it has no inside");
}

}  // namespace maquette::sim
