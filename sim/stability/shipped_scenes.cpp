#include "sim/stability/shipped_scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "sim/scene/picture_files.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {

namespace {

namespace fs = std::filesystem;

/// Studies vary scenes and are none.
constexpr const char* k_studies = "studies";

bool is_scene(const fs::path& file) {
  return file.extension() == ".yaml" && file.parent_path().filename() != k_studies;
}

}  // namespace

std::vector<ShippedScene> shipped_scenes(const std::string& directory) {
  std::vector<ShippedScene> scenes;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory, error)) {
    if (is_scene(entry.path())) {
      const fs::path name = entry.path().lexically_relative(directory).replace_extension();
      InputFile file = read_input(entry.path().string());
      YamlNode written = parse_yaml(file);
      std::vector<InputFile> pictures;
      inline_pictures(written, pictures);
      scenes.push_back({name.generic_string(), std::move(file), written, read_scene(written)});
    }
  }
  if (scenes.empty()) {
    throw DescriptionError(directory + ": no scene is there");
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const ShippedScene& a, const ShippedScene& b) { return a.name < b.name; });
  return scenes;
}

}  // namespace maquette::sim
