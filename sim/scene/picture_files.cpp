#include "sim/scene/picture_files.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "sim/fields/value_types.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/override.hpp"

namespace maquette::sim {

namespace {

namespace fs = std::filesystem;

/// The bytes of a file; nothing where there is none, or one that no board could hold.
std::string bytes_of(const fs::path& file) {
  constexpr std::uintmax_t k_most_bytes = 64 << 20;
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > k_most_bytes || error) {
    return {};
  }
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

models::Picture read_picture(const fs::path& file, const YamlPlace& place) {
  const std::string bytes = bytes_of(file);
  if (bytes.empty()) {
    throw DescriptionError(place.position(), "picture: `" + file.string() +
                                                 "` cannot be read; a PNG file of three "
                                                 "8-bit channels is allowed");
  }
  try {
    return decode_png(bytes, file.string());
  } catch (const DescriptionError& error) {
    throw DescriptionError(place.position(), std::string("picture: ") + error.what() +
                                                 "; a PNG file of three 8-bit channels is allowed");
  }
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

void inline_pictures(YamlNode& scene, std::vector<std::string>& input_files) {
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
    *picture = texels_of(read_picture(file, place));
    set_place(*picture, place);
    if (std::find(input_files.begin(), input_files.end(), file.string()) == input_files.end()) {
      input_files.push_back(file.string());
    }
  }
}

}  // namespace maquette::sim
