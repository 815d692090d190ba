#include "sim/scene/picture_files.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "sim/fields/value_types.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/override.hpp"

namespace maquette::sim {

namespace {

namespace fs = std::filesystem;

models::Picture picture_of(const InputFile& file, const YamlPlace& place) {
  try {
    return decode_png(file.content, file.path);
  } catch (const DescriptionError& error) {
    throw DescriptionError(place.position(), std::string("picture: ") + error.what() +
                                                 "; a PNG file of three 8-bit channels is allowed");
  }
}

/// The file among those that were read; it is read if it is not there.
const InputFile& input_of(const std::string& file, const YamlPlace& place,
                          std::vector<InputFile>& input_files) {
  const auto found = std::find_if(input_files.begin(), input_files.end(),
                                  [&file](const InputFile& input) { return input.path == file; });
  if (found != input_files.end()) {
    return *found;
  }
  try {
    input_files.push_back(read_input(file));
  } catch (const DescriptionError&) {
    throw DescriptionError(place.position(), "picture: `" + file +
                                                 "` cannot be read; a PNG file of three "
                                                 "8-bit channels is allowed");
  }
  return input_files.back();
}

YamlNode texels_of(const models::Picture& picture) {
  std::vector<std::uint8_t> texels;
  for (const std::uint32_t pixel : picture.pixels) {
    for (const int shift : {16, 8, 0}) {
      texels.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  YamlNode node = yaml_mapping();
  append(node, "columns", yaml_scalar(std::to_string(picture.width)));
  append(node, "rows", yaml_scalar(std::to_string(picture.height)));
  append(node, "texels", HexadecimalType::write(texels));
  return node;
}

void set_place(YamlNode& node, const YamlPlace& place) {
  node.place = place;
  for (YamlEntry& entry : node.entries) {
    entry.place = place;
    entry.value.place = place;
  }
}

}  // namespace

void inline_pictures(YamlNode& scene, std::vector<InputFile>& input_files) {
  YamlNode* surfaces = scene.find("surfaces");
  if (surfaces == nullptr) {
    return;
  }
  for (YamlEntry& surface : surfaces->entries) {
    YamlNode* texture = surface.value.find("texture");
    YamlNode* picture = texture == nullptr ? nullptr : texture->find("picture");
    if (picture == nullptr || picture->kind != YamlKind::scalar) {
      continue;
    }
    const YamlPlace place = picture->place;
    const bool is_in_file = place.file && !is_from_override(place);
    const fs::path folder = is_in_file ? fs::path{*place.file}.parent_path() : fs::path{};
    const fs::path file = folder / picture->text;
    *picture = texels_of(picture_of(input_of(file.string(), place, input_files), place));
    set_place(*picture, place);
  }
}

}  // namespace maquette::sim
