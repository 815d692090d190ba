#include "sim/scene/picture_files.hpp"

#include "sim/picture/image_file.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::string scene_with(const std::string& picture) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {texture: {picture: " +
         picture + "}}}\nobject: {sphere: {radius: 1}, surface: red}\n";
}

Description load_in(const tests::ScratchDirectory& directory, const std::string& scene) {
  return load_description(
      {write_file(directory, "scene.yaml", scene), {}, {}, data_directory().string()});
}

TEST_CASE("The texels of a file beside the scene take the place of its name") {
  const tests::ScratchDirectory directory;
  write_file(directory, "dots.png", encode_png({2, 1, {0x010203, 0xF0E0D0}}));
  const Description description = load_in(directory, scene_with("dots.png"));
  const TexturePicture& picture = *description.scene.surfaces.at(0).texture->picture;
  CHECK(picture.columns == 2);
  CHECK(picture.rows == 1);
  CHECK(picture.texels == std::vector<std::uint8_t>{1, 2, 3, 0xF0, 0xE0, 0xD0});
  // What is written holds the texels, so that it can be run from anywhere.
  const std::string written = write_yaml(write_scene(description.scene));
  CHECK(written.find("dots.png") == std::string::npos);
  CHECK(written.find("010203f0e0d0") != std::string::npos);
}

TEST_CASE("Frames of a sequence may have pictures of their own") {
  const tests::ScratchDirectory directory;
  write_file(directory, "a.png", encode_png({1, 1, {0x010203}}));
  write_file(directory, "b.png", encode_png({1, 1, {0x040506}}));
  const Description description =
      load_in(directory,
              scene_with("a.png") +
                  "sequence: {frames: 2, vary: {surfaces.red.texture.picture: [a.png, b.png]}}\n");
  CHECK(description.frames.at(1).surfaces.at(0).texture->picture->texels ==
        std::vector<std::uint8_t>{4, 5, 6});
  // Scene, machine, its two cost tables and the two pictures, each once.
  CHECK(description.input_files.size() == 6);
}

TEST_CASE("A picture that is not there or is none is refused at its name") {
  const tests::ScratchDirectory directory;
  write_file(directory, "text.png", "no picture");
  const auto error_with = [&](const std::string& picture) {
    try {
      load_in(directory, scene_with(picture));
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(error_with("missing.png").find(":2:37: picture: ") != std::string::npos);
  CHECK(error_with(".").find(":2:37: picture: ") != std::string::npos);
  CHECK(error_with("/dev/zero").find(":2:37: picture: ") != std::string::npos);
  CHECK(error_with("missing.png").find("a PNG file of three 8-bit channels is allowed") !=
        std::string::npos);
  CHECK(error_with("text.png").find(":2:37: picture: ") != std::string::npos);
  CHECK(error_with("{columns: 2, rows: 1, texels: 010203}").find("texels: 3 bytes") !=
        std::string::npos);
  CHECK(error_with("{columns: 1, rows: 1, texels: 01020g}").find("hexadecimal") !=
        std::string::npos);
  CHECK(error_with("{columns: 1, rows: 1, texels: 01020}").find("hexadecimal") !=
        std::string::npos);
}

}  // namespace
}  // namespace maquette::sim
