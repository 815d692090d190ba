#include "sim/primitives/torus.hpp"

#include <cmath>

#include "sim/primitives/primitive_description.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

std::string scene_with(const std::string& torus) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5}}\n"
         "object:\n  surface: red\n  torus:\n    " +
         torus + "\n";
}

}  // namespace

TEST_CASE("The surface of the local frame becomes that of both radii") {
  Random random(4201);
  for (int i = 0; i < 1000; ++i) {
    TorusShape shape;
    shape.major_radius = random.magnitude(1e-6, 1e6);
    shape.minor_radius = shape.major_radius * random.magnitude(1e-4, 0.999);
    const LocalFrame frame = frame_of(shape);
    const firmware::FacePoint<double> local =
        firmware::torus::settle(random.in_cube(), 0, frame.parameters.data());
    const Vector3 p = firmware::transform_point(frame.to_object, local.position);
    const double apart =
        std::hypot(std::hypot(p.x, p.y) - shape.major_radius, p.z) - shape.minor_radius;
    CAPTURE(i, shape.major_radius, shape.minor_radius);
    REQUIRE(std::fabs(apart) < 1e-14 * shape.major_radius);
  }
}

TEST_CASE("A torus takes its tolerance of roots from the scene") {
  const PrimitiveDescription& torus = description_of<firmware::torus::Kind>();
  const LocalFrame frame = frame_of(TorusShape{});
  CHECK(frame.parameters.at(static_cast<std::size_t>(torus.root_tolerance)) == 1);
}

TEST_CASE("A torus that has no hole is refused with its place") {
  const auto check = [](const std::string& torus, const std::string& place,
                        const std::string& expected) {
    const std::string message = error_of(scene_with(torus));
    INFO(message);
    CHECK(message.find(place) == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  CHECK(error_of(scene_with("{major_radius: 2, minor_radius: 1.999}")).empty());
  const std::string reason = "leaves no hole; less than major_radius, 2, is allowed";
  check("{major_radius: 2, minor_radius: 2}", "scene.yaml:6:37: ", "minor_radius: 2 " + reason);
  check("{major_radius: 2, minor_radius: 3}", "scene.yaml:6:37: ", "minor_radius: 3 " + reason);
  check("major_radius: 2", "scene.yaml:6:", "`minor_radius` is missing");
  check("minor_radius: 2", "scene.yaml:6:", "`major_radius` is missing");
  check("{major_radius: 2, minor_radius: 0}", "scene.yaml:6:", "minor_radius: ");
  check("{major_radius: 2, minor_radius: -1}", "scene.yaml:6:", "minor_radius: ");
  check("{major_radius: .inf, minor_radius: 1}", "scene.yaml:6:", "major_radius: ");
  check("{major_radius: 2, minor_radius: 1, radius: 1}", "scene.yaml:6:", "radius");
}

}  // namespace maquette::sim
