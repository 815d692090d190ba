#include "sim/primitives/terrain.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

TerrainShape random_terrain(Random& random, double unit) {
  TerrainShape shape;
  shape.seed = random.below(firmware::terrain::k_seed_end);
  shape.levels = random.below(9);
  shape.size = unit * random.uniform(1, 10);
  shape.displacement = unit * random.uniform(0, 2);
  shape.roughness = random.uniform();
  for (glm::dvec2& pair : shape.corners) {
    pair = {unit * random.uniform(), unit * random.uniform()};
  }
  shape.depth = unit * random.uniform(0, 3);
  return shape;
}

}  // namespace

TEST_CASE("A terrain keeps its heights in its local frame, whatever its unit") {
  Random random(21);
  for (int i = 0; i < 200; ++i) {
    const TerrainShape shape = random_terrain(random, random.magnitude(1e-5, 1e5));
    const LocalFrame frame = frame_of(shape);
    const double* parameters = frame.parameters.data();
    firmware::Box<double> box{};
    REQUIRE(firmware::terrain::bounds(parameters, box));
    CHECK(firmware::magnitude(box.low) <= 1);
    CHECK(std::max(box.high.z, -box.low.z) == Approx(1));
    const Vector3 low(0, 0, box.low.z);
    const Vector3 corner(
        1, 0,
        firmware::terrain::triangle_at(firmware::terrain::relief(parameters), 1.0, 0.0).corner);
    const Vector3 floor_point = firmware::transform_point(frame.to_object, low);
    const Vector3 corner_point = firmware::transform_point(frame.to_object, corner);
    CHECK(floor_point.x == Approx(-shape.size / 2));
    CHECK(floor_point.z == Approx(-shape.depth));
    CHECK(corner_point.x == Approx(shape.size / 2));
    CHECK(corner_point.y == Approx(-shape.size / 2));
    CHECK(corner_point.z == Approx(shape.corners[0].y));
  }
}

TEST_CASE("A terrain that makes no solid is refused with the reason") {
  const auto error = [](const std::string& terrain) {
    return error_of(
        "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
        "surfaces: {rock: {diffuse: 0.5}}\n"
        "object:\n  surface: rock\n  terrain:\n    " +
        terrain + "\n");
  };
  const auto check = [&error](const std::string& terrain, const std::string& expected) {
    const std::string message = error(terrain);
    INFO(message);
    CHECK(message.find("scene.yaml:6:") == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  CHECK(error("{levels: 6, size: 2, displacement: 0.3, depth: 1}").empty());
  CHECK(error("{levels: 0, size: 2, displacement: 0, depth: 1}").empty());
  CHECK(error("{levels: 6, size: 2, displacement: 0.3, depth: 0, seed: 9, roughness: 40 %,\n"
              "     corners: [[0, 1], [-1, 2]]}")
            .empty());
  check("{size: 2, displacement: 0.3, depth: 1}", "`levels` is missing");
  check("{levels: 11, size: 2, displacement: 0.3, depth: 1}", "levels: ");
  check("{levels: 6, size: 0, displacement: 0.3, depth: 1}", "size: ");
  check("{levels: 6, size: 2, displacement: .nan, depth: 1}", "displacement: ");
  check("{levels: 6, size: 2, displacement: 0.3, depth: 1, seed: 16777216}", "seed: ");
  check("{levels: 6, size: 2, displacement: 0.3, depth: 1, roughness: 2}", "roughness: ");
  check("{levels: 6, size: 2, displacement: 0.3, depth: 1, corners: [[0, 0]]}",
        "1 pairs of heights; two are allowed");
  check("{levels: 0, size: 2, displacement: 0.3, depth: 0}", "lies all below its floor");
  check("{levels: 6, size: 2, displacement: 0.1, depth: 1, corners: [[-2, -2], [-3, -2]]}",
        "lies all below its floor");
}

}  // namespace maquette::sim
