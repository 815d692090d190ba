#include "sim/page/layers.hpp"

#include <algorithm>
#include <cmath>

#include "sim/page/data_url.hpp"
#include "sim/picture/image_file.hpp"

namespace maquette::sim {
namespace {

constexpr std::uint32_t k_no_value = 0xFFFFFF;
constexpr double k_codes = 0xFFFFFE;

struct Range {
  double low = 0;
  double high = 0;
};

/// From zero where no value is below.
Range range_of(const std::vector<double>& values) {
  Range range;
  for (const double value : values) {
    if (std::isfinite(value)) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  return range;
}

/// What one step of the codes is: 1 where values are whole.
double step_of(const Map& map, const Range& range) {
  const bool is_whole = map.kind == MapKind::count || map.kind == MapKind::name;
  return is_whole && range.high <= k_codes ? 1 : (range.high - range.low) / k_codes;
}

std::string packed(const std::vector<double>& values, const Range& range, double step,
                   const models::PixelRectangle& zone) {
  models::Picture picture;
  picture.width = zone.width;
  picture.height = zone.height;
  for (const double value : values) {
    picture.pixels.push_back(
        std::isfinite(value) ? static_cast<std::uint32_t>(std::lround((value - range.low) / step))
                             : k_no_value);
  }
  return encode_png(picture);
}

}  // namespace

const std::vector<std::string>& page_maps() {
  static const std::vector<std::string> names = [] {
    // Time by function and work by class take the run longer than all others together.
    constexpr const char* k_left_out[] = {"count_error", "function.", "work.", "normal.", "root"};
    std::vector<std::string> all;
    for (const Map& map : all_maps()) {
      if (std::none_of(std::begin(k_left_out), std::end(k_left_out),
                       [&map](const char* start) { return map.name.rfind(start, 0) == 0; })) {
        all.push_back(map.name);
      }
    }
    return all;
  }();
  return names;
}

nlohmann::ordered_json layers_of(const ReadMaps& maps) {
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (const ReadMap& read : maps.maps) {
    const Range range = range_of(read.values);
    const bool has_values = range.high > range.low;
    if (has_values || read.map->kind == MapKind::name) {
      const double step = has_values ? step_of(*read.map, range) : 1;
      layers.push_back(
          {{"name", read.map->name},
           {"title", read.map->title},
           {"unit", read.map->unit},
           {"is_name", read.map->kind == MapKind::name},
           {"names", read.names},
           {"low", range.low},
           {"high", range.high},
           {"step", step},
           {"png", data_url("image/png", packed(read.values, range, step, maps.zone))}});
    }
  }
  return layers;
}

}  // namespace maquette::sim
