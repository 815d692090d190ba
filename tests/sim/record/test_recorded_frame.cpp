#include "sim/record/recorded_frame.hpp"

#include <set>
#include <string>
#include <vector>

#include "sim/database/packed_scene.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

using namespace maquette::sim;

namespace {

/// A scene whose database has an entry in every array that a key must not know the place of.
std::string scene_of(const std::string& radius, const std::string& color) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "lights: {lamp: {position: [2, -3, 8], falloff: 3}}\n"
         "surfaces: {red: {diffuse: [0.5, 0, 0.2], ambient: 0.5,"
         " texture: {pattern: bands, size: 0.5, color: " +
         color +
         "}}}\n"
         "object: {union: [{sphere: {radius: " +
         radius + "}}, {box: {size: 1}}], surface: red}\n";
}

RecordKey key_of(const std::string& text, PictureFormat format = {64, 48, false}) {
  return record_key_of(packed_scene<float>(load_text(text).scene, format));
}

}  // namespace

TEST_CASE("the key of a recorded frame does not depend on where memory holds the scene") {
  const std::string text = scene_of("2", "[0.25, 0.5, 0.2]");
  std::set<std::string> names;
  std::vector<PackedScene<float>> kept;  // so that each has arrays of its own
  for (int i = 0; i < 4; ++i) {
    kept.push_back(packed_scene<float>(load_text(text).scene, {64, 48, false}));
    names.insert(record_key_of(kept.back()).name());
  }
  CHECK(names.size() == 1);
}

TEST_CASE("whatever the firmware would see otherwise has another key") {
  const std::set<std::string> names{
      key_of(scene_of("2", "[0.25, 0.5, 0.2]")).name(),
      key_of(scene_of("2.0001", "[0.25, 0.5, 0.2]")).name(),
      key_of(scene_of("2", "[0.25, 0.5, 0.21]")).name(),
      key_of(scene_of("2", "[0.25, 0.5, 0.2]"), {65, 48, false}).name(),
      key_of(scene_of("2", "[0.25, 0.5, 0.2]"), {64, 49, false}).name(),
      key_of("extents: none\n" + scene_of("2", "[0.25, 0.5, 0.2]")).name()};
  CHECK(names.size() == 6);
}

TEST_CASE("each part of a key counts in its name") {
  const RecordKey key{"abc", "def", {3, 4, false}};
  std::set<std::string> names{key.name()};
  for (RecordKey other : {key, key, key, key}) {
    switch (names.size()) {
      case 1:
        other.scene_sha1 = "abd";
        break;
      case 2:
        other.firmware = "deg";
        break;
      case 3:
        other.format.width = 5;
        break;
      default:
        other.format.has_depth = true;
    }
    const std::size_t before = names.size();
    names.insert(other.name());
    CHECK(names.size() == before + 1);
  }
  CHECK(RecordKey{key}.name() == key.name());
}
