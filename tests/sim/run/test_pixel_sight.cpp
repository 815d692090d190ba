#include "sim/run/pixel_sight.hpp"

#include <cmath>

#include "sim/database/prepared_scene.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_sphere = R"(
view: {eye: [0, -5, 0], target: [0, 0, 0], up: [0, 0, 1], field_of_view: 30 deg}
lights: {key: {position: [5, -6, 8], intensity: [1, 1, 1]}}
surfaces: {red: {diffuse: [1, 0, 0]}}
object: {sphere: {radius: 1}, surface: red}
)";

/// Two mirrors that face one another, the eye between them.
constexpr const char* k_mirrors = R"(
view: {eye: [0, 0, 0], target: [0, 1, 0], up: [0, 0, 1], field_of_view: 10 deg}
lights: {key: {position: [0.5, 0, 1], intensity: [1, 1, 1]}}
surfaces: {mirror: {specular: 1, metal: {index: [0.15, 0.14, 0.13], extinction: [3.9, 3.2, 2.4]}, half_angle: 4 deg}}
ray_tree: {depth: 5, minimum_weight: 0.0001}
object:
  union:
    - box: {size: [9, 1, 9]}
      place: {translate: [0, 3, 0]}
    - box: {size: [9, 1, 9]}
      place: {translate: [0, -3, 0]}
  surface: mirror
)";

const std::vector<std::string> k_frame = {"frame_memory.width=65 pixels",
                                          "frame_memory.height=65 pixels"};

template <class Check>
void look_at(const std::string& scene, Check check) {
  const Description description = load_text(scene, k_frame);
  const PreparedScene<float> prepared(
      packed_scene<float>(description.scene, picture_format_of(description.machine)));
  SynthesisArea<float> area(prepared.frame().database);
  for (int row = 0; row < 65; ++row) {
    for (int column = 0; column < 65; ++column) {
      check(pixel_sight(prepared.frame(), area.view(), {column, row}), column, row);
    }
  }
}

TEST_CASE("A sphere is seen where it is, with its distance and normal") {
  int seen = 0;
  look_at(k_sphere, [&seen](const PixelSight& sight, int column, int row) {
    CHECK(sight.tree_depth == 0);
    if (!sight.is_seen) {
      return;
    }
    ++seen;
    const auto& n = sight.normal;
    CHECK(std::hypot(n[0], n[1], n[2]) == Approx(1).epsilon(1e-5));
    CHECK(n[2] < 0);
    CHECK(sight.distance >= Approx(4));
    CHECK(sight.distance <= Approx(std::sqrt(24)));
    // To the right of the middle the normal points to the right, above it upwards.
    CHECK(static_cast<float>(column - 32) * n[0] >= -1e-4F);
    CHECK(static_cast<float>(32 - row) * n[1] >= -1e-4F);
    CHECK(sight.primitive == 0);
    CHECK(sight.surface == 0);
  });
  CHECK(seen > 1000);
}

TEST_CASE("Between mirrors the tree of rays is as deep as it may be") {
  look_at(k_mirrors, [](const PixelSight& sight, int, int) {
    CHECK(sight.is_seen);
    CHECK(sight.tree_depth == 5);
  });
}

}  // namespace
}  // namespace maquette::sim
