#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "sim/scene/description_loader.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

/// What the tests of descriptions share.
namespace maquette::sim {

inline std::filesystem::path data_directory() { return MAQUETTE_PROJECT_DIRECTORY; }

inline std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Writes a file below the directory and returns its path.
inline std::string write_file(const tests::ScratchDirectory& directory, const std::string& name,
                              const std::string& text) {
  const std::filesystem::path file = directory.path() / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream{file, std::ios::binary} << text;
  return file.string();
}

/// Loads a scene from its text.
inline Description load_text(const std::string& scene, std::vector<std::string> overrides = {}) {
  const tests::ScratchDirectory directory;
  return load_description({write_file(directory, "scene.yaml", scene),
                           {},
                           std::move(overrides),
                           data_directory().string()});
}

/// The message about a broken scene, without the directory; empty when it loads.
inline std::string error_of(const std::string& scene, std::vector<std::string> overrides = {}) {
  try {
    static_cast<void>(load_text(scene, std::move(overrides)));
  } catch (const DescriptionError& error) {
    const std::string message = error.what();
    const std::size_t name = message.find("scene.yaml:");
    return name == std::string::npos ? message : message.substr(name);
  }
  return {};
}

/// A scene that uses every key.
inline const std::string k_rich_scene = R"(name: rich
paper_time: {value: 420 s, source: "a section, a photograph"}
view: {eye: [4, -6, 3], target: [0, 0, 0.5], up: [0, 0, 1], field_of_view: 35 deg}
lights:
  key: {position: [10, -10, 20], intensity: [3, 3, 3]}
  fill: {position: [-10, -10, 5], intensity: 0.5}
ambient: [0.2, 0.2, 0.2]
background: [0.1, 0.1, 0.3]
shadows: true
ray_tree: {depth: 4, minimum_weight: 0.0039}
surfaces:
  red: {diffuse: [0.8, 0.1, 0.1]}
  gold:
    specular: 1
    metal: {index: [0.17, 0.35, 1.5], extinction: [3.1, 2.7, 1.9]}
    facets: gaussian
    half_angle: 12 deg
  glass: {specular: 100 %, index: 1.5, transparent: true, absorption: [0.1, 0.2, 0.3]}
object:
  union:
    - name: ball
      sphere: {radius: 1}
      surface: red
      place: [{scale: 2}, {rotate: {axis: [1, 2, 3], angle: 30 deg}}, {translate: [0, 0, 1]}]
    - difference:
        - box: {size: [1, 2, 3]}
        - cylinder: {radius: 0.2, height: 5}
          place: {translate: [0, 0, -2.5]}
        - cone: {radius: 1, top_radius: 0.5, height: 0.3}
      surface: gold
    - algebraic: {size: 2, terms: [[4, 0, 0, 1], [0, 4, 0, 1], [0, 0, 3, -1.5], [0, 0, 0, -0.5]]}
      surface: red
    - prism:
        height: 0.5
        contours: [polygon: [[0, 0], [1, 0], [0, 1]], spline: [[0.2, 0.2], [0.4, 0.2], [0.2, 0.4]]]
      surface: red
    - intersection:
        - half_space: {}
        - sphere: {radii: [1, 2, 3]}
          surface: glass
          place: {matrix: [1, 0, 0, 4, 0, 0, -1, 5, 0, 1, 0, 6]}
      surface: red
)";

}  // namespace maquette::sim
