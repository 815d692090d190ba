#include "sim/scene/sequence.hpp"

#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::string scene_with(const std::string& sequence) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: 0.5, half_angle: 10 deg}}\n"
         "sequence: " +
         sequence + "\nobject: {sphere: {radius: 1}, surface: red}\n";
}

TEST_CASE("Each frame has its values, a list's or evenly from one to another") {
  const Description description = load_text(
      scene_with("{frames: 3, vary: {object.sphere.radius: [1, 4, 2], view.eye: {from: [4, -6, 3], "
                 "to: [4, -4, 1]}, surfaces.red.half_angle: {from: 10 deg, to: 20 deg}}}"));
  REQUIRE(description.frames.size() == 3);
  const double radii[] = {1, 4, 2};
  for (int frame = 0; frame < 3; ++frame) {
    const Scene& scene = description.frames[static_cast<std::size_t>(frame)];
    CHECK_FALSE(scene.sequence);
    CHECK(scene.view.eye == Vector3(4, -6 + frame, 3 - frame));
    CHECK(scene.surfaces[0].half_angle_deg == 10 + 5 * frame);
    const LocalFrame local = frame_of(*scene.object.primitive);
    CHECK(local.to_object[0].x == radii[frame]);
  }
  CHECK(description.scene.sequence->frames == 3);
  CHECK(description.scene.view.eye == Vector3(4, -6, 3));
}

TEST_CASE("A scene without a sequence has no frames") {
  CHECK(load_text("view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
                  "surfaces: {red: {diffuse: 0.5}}\nobject: {sphere: {radius: 1}, surface: red}\n")
            .frames.empty());
}

TEST_CASE("What was read is written with a value for each frame, and reads back the same") {
  const std::string scene =
      scene_with("{frames: 3, vary: {object.sphere.radius: {from: 1, to: 2}}}");
  const Description first = load_text(scene);
  const Description again = load_text(effective_configuration(first.scene, first.machine));
  CHECK(effective_configuration(again.scene, again.machine) ==
        effective_configuration(first.scene, first.machine));
  CHECK(again.frames.size() == 3);
}

TEST_CASE("Sequences that cannot be are refused") {
  const auto check_error = [](const std::string& sequence, const std::string& place,
                              const std::string& expected) {
    const std::string error = error_of(scene_with(sequence));
    CAPTURE(sequence, error);
    CHECK(error.rfind("scene.yaml:3:" + place, 0) == 0);
    CHECK(error.find(expected) != std::string::npos);
  };
  check_error("{frames: 2}", "11: ", "frames and vary");
  check_error("{frames: 0, vary: {}}", "20: frames", "1 to 10000");
  check_error("{frames: 2, vary: {view.eye: [[1, 2, 3]]}}", "40: ", "1 values, but 2 frames");
  check_error("{frames: 2, vary: {view.ey: [1, 2]}}", "", "view");
  check_error("{frames: 2, vary: {object.sphere.radius: [1, 0]}}", "56: radius: ", "above 0");
  check_error("{frames: 2, vary: {object.sphere.radius: {from: 1}}}", "52: ", "from: A, to: B");
  check_error("{frames: 2, vary: {object.sphere.radius: {from: 1, to: 2 deg}}}", "", "unit");
  check_error("{frames: 2, vary: {machine: [ccett-1984, m68020]}}", "30: ", "same for all frames");
  check_error("{frames: 2, vary: {sequence.frames: [1, 2]}}", "30: ", "same for all frames");
  check_error("{frames: 2, vary: {name: {from: a, to: b}}}", "", "numbers");
}

}  // namespace
}  // namespace maquette::sim
