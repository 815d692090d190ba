#include "sim/maps/map_reading.hpp"

#include <algorithm>
#include <cstring>

#include "sim/maps/map_files.hpp"
#include "sim/picture/picture_module.hpp"
#include "sim/picture_module/exr_codec.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

void decode(const std::string& bytes, const std::string& name, ExrImage& image) {
  const ExrCodec& codec =
      *reinterpret_cast<const ExrCodec* (*)()>(picture_module_function(k_exr_codec_function))();
  if (const std::string error = codec.decode(bytes, image); !error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
}

std::vector<std::string> listed(const std::string& list) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    names.push_back(list.substr(at, end - at));
    at = end + 2;
  }
  return names;
}

double value_of(MapKind kind, std::uint32_t bits) {
  if (kind == MapKind::count) {
    return bits;
  }
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

ReadMaps decode_maps(const std::string& bytes, const std::string& name) {
  ExrImage image;
  image.attributes = {{k_maps_attribute, ""}};
  decode(bytes, name, image);
  ReadMaps read;
  const std::vector<Map> known = maps_named(listed(image.attributes[k_maps_attribute]));
  for (const Map& map : all_maps()) {
    for (const Map& held : known) {
      if (held.name == map.name) {
        read.maps.push_back({&map, {}, {}});
        image.channels.push_back(
            {map.name, map.kind == MapKind::count ? ExrStorage::count : ExrStorage::real, {}});
        image.attributes["names." + map.name] = "";
      }
    }
  }
  decode(bytes, name, image);
  read.zone.column0 = image.data_column;
  read.zone.row0 = image.data_row;
  read.zone.width = image.data_width;
  read.zone.height = image.data_height;
  for (std::size_t i = 0; i < read.maps.size(); ++i) {
    ReadMap& map = read.maps[i];
    map.names = image.attributes["names." + map.map->name];
    for (const std::uint32_t bits : image.channels[i].values) {
      map.values.push_back(value_of(map.map->kind, bits));
    }
  }
  return read;
}

}  // namespace maquette::sim
