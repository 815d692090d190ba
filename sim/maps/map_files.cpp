#include "sim/maps/map_files.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "sim/maps/map_picture.hpp"
#include "sim/picture/picture_module.hpp"
#include "sim/picture_module/exr_codec.hpp"

namespace maquette::sim {

namespace {

const ExrCodec& codec() {
  static const ExrCodec& loaded =
      *reinterpret_cast<const ExrCodec* (*)()>(picture_module_function(k_exr_codec_function))();
  return loaded;
}

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

ExrChannel channel_of(const Map& map, const PixelFacts& facts) {
  const bool is_count = map.kind == MapKind::count;
  ExrChannel channel{map.name, is_count ? ExrStorage::count : ExrStorage::real, {}};
  for (const double value : told_values(map, facts)) {
    channel.values.push_back(is_count ? static_cast<std::uint32_t>(value)
                                      : bits_of(static_cast<float>(value)));
  }
  return channel;
}

}  // namespace

std::string encode_maps(const std::vector<Map>& maps, const PixelFacts& facts) {
  ExrImage image;
  image.width = facts.width;
  image.height = facts.height;
  image.data_column = facts.zone.column0;
  image.data_row = facts.zone.row0;
  image.data_width = facts.zone.width;
  image.data_height = facts.zone.height;
  for (const Map& map : maps) {
    std::string& listed = image.attributes[k_maps_attribute];
    listed += (listed.empty() ? "" : ", ") + map.name;
    image.channels.push_back(channel_of(map, facts));
    image.attributes["unit." + map.name] = map.unit;
    image.attributes["title." + map.name] = map.title;
    if (map.names != nullptr) {
      image.attributes["names." + map.name] = fmt::format("{}", fmt::join(facts.*map.names, ", "));
    }
  }
  std::string bytes;
  if (const std::string error = codec().encode(image, bytes); !error.empty()) {
    throw std::runtime_error(error);
  }
  return bytes;
}

std::vector<NamedContent> map_files(const std::vector<Map>& maps, const std::vector<Map>& drawn,
                                    const PixelFacts& facts, const std::string& scene) {
  std::vector<NamedContent> files;
  if (maps.empty() || facts.zone.pixels() == 0) {
    return files;
  }
  files.push_back({"maps.exr", encode_maps(maps, facts)});
  for (const Map& map : drawn) {
    files.push_back({"map-" + map.name + ".png", map_picture(map, facts, scene)});
  }
  return files;
}

}  // namespace maquette::sim
