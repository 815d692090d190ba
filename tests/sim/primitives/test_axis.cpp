#include "sim/primitives/axis.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "sim/primitives/cone.hpp"
#include "sim/primitives/cylinder.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

double distance_to_axis(const Vector3& p, const Vector3& from, const Vector3& along) {
  return glm::length(glm::cross(p - from, along));
}

std::string scene_with(const std::string& object) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}}\n"
         "object:\n  surface: red\n  " +
         object + "\n";
}

}  // namespace

TEST_CASE("A cylinder between two points has them as middles of its ends") {
  Random random(4401);
  for (int i = 0; i < 500; ++i) {
    const Vector3 from = random.in_cube(10);
    const Vector3 to =
        i % 3 == 0 ? from + Vector3(0, 0, random.uniform(-3, 3)) : random.in_cube(10);
    const double radius = random.magnitude(0.01, 10);
    const LocalFrame frame = frame_of(CylinderShape{radius, {{}, from, to}});
    const auto at = [&](double x, double y, double z) {
      return firmware::transform_point(frame.to_object, Vector3(x, y, z));
    };
    REQUIRE(glm::length(at(0, 0, -1) - from) < 1e-12);
    REQUIRE(glm::length(at(0, 0, 1) - to) < 1e-12);
    const double angle = random.uniform(0, 6);
    const Vector3 side = at(std::cos(angle), std::sin(angle), random.uniform(-1, 1));
    REQUIRE(distance_to_axis(side, from, glm::normalize(to - from)) == Approx(radius));
    REQUIRE(firmware::trial::determinant(frame.to_object) > 0);
  }
}

TEST_CASE("A cone between two points has its radii there, whichever is larger") {
  Random random(4402);
  for (int i = 0; i < 500; ++i) {
    const Vector3 from = random.in_cube(10);
    const Vector3 to = random.in_cube(10);
    ConeShape shape{random.magnitude(0.1, 10), random.coin() ? 0 : random.magnitude(0.1, 10), {}};
    ConeShape upright = shape;
    shape.axis = {{}, from, to};
    upright.axis.height = glm::length(to - from);
    const Vector3 along = glm::normalize(to - from);
    const LocalFrame frame = frame_of(shape);
    const LocalFrame straight = frame_of(upright);
    REQUIRE(frame.parameters == straight.parameters);
    const Vector3 local = random.in_cube();
    const Vector3 p = firmware::transform_point(frame.to_object, local);
    const Vector3 q = firmware::transform_point(straight.to_object, local);
    CHECK(glm::dot(p - from, along) == Approx(q.z).margin(1e-10));
    CHECK(distance_to_axis(p, from, along) == Approx(std::hypot(q.x, q.y)).margin(1e-10));
  }
}

TEST_CASE("An axis is a height or two points") {
  using Catch::Matchers::ContainsSubstring;
  CHECK(error_of(scene_with("cone: {radius: 1, from: [0, 0, 1], to: [1, 0, 0]}")).empty());
  CHECK_THAT(error_of(scene_with("cone: {radius: 1, height: 1, from: [0, 0, 1], to: [1, 0, 0]}")),
             ContainsSubstring("scene.yaml:5:38: from: a height is given; one of height, from with "
                               "to is allowed"));
  CHECK_THAT(error_of(scene_with("cylinder: {radius: 1, from: [0, 0, 1]}")),
             ContainsSubstring("one of height, from with to is allowed and needed"));
  CHECK_THAT(error_of(scene_with("cylinder: {radius: 1}")),
             ContainsSubstring("one of height, from with to is allowed and needed"));
  CHECK_THAT(error_of(scene_with("cylinder: {radius: 1, from: [0, 0, 1], to: [0, 0, 1]}")),
             ContainsSubstring("to: it is where `from` is; another point is allowed"));
}

}  // namespace maquette::sim
