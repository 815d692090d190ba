#include "sim/maps/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sim/picture/picture_module.hpp"
#include "sim/picture/png_codec.hpp"

namespace maquette::sim {

namespace {

constexpr double k_ticks_per_s = 1e12;

/// More names than these are not told apart by colours.
constexpr std::size_t k_most_names = 8;

/// A unit in which numbers of a map have few digits.
struct Scale {
  double factor = 1;
  const char* prefix = "";
};

Scale scale_of(const Map& map, double largest) {
  if (map.kind != MapKind::time || largest >= 1 || largest <= 0) {
    return {};
  }
  constexpr Scale k_scales[] = {{1e3, "m"}, {1e6, "u"}, {1e9, "n"}, {1e12, "p"}};
  for (const Scale& scale : k_scales) {
    if (largest * scale.factor >= 1) {
      return scale;
    }
  }
  return k_scales[3];
}

/// The range of the values that are numbers, and zero where none is below.
std::pair<double, double> range_of(const std::vector<double>& values, bool from_zero) {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  for (const double value : values) {
    if (!std::isnan(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) {
    return {0, 1};
  }
  low = from_zero && low > 0 ? 0 : low;
  return {low, high > low ? high : low + 1};
}

const MapCodec& codec() {
  static const MapCodec& loaded =
      *reinterpret_cast<const MapCodec* (*)()>(picture_module_function(k_map_codec_function))();
  return loaded;
}

std::string place_of(const PixelFacts& facts, const std::string& scene) {
  const models::PixelRectangle& zone = facts.zone;
  return fmt::format("{}{}columns {} to {}, rows {} to {} of {} x {}", scene,
                     scene.empty() ? "" : ": ", zone.column0, zone.column0 + zone.width - 1,
                     zone.row0, zone.row0 + zone.height - 1, facts.width, facts.height);
}

}  // namespace

std::vector<double> told_values(const Map& map, const PixelFacts& facts) {
  std::vector<double> values;
  const auto pixels = static_cast<std::size_t>(facts.zone.pixels());
  values.reserve(pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const double value = map.value(facts, pixel);
    values.push_back(map.kind == MapKind::time ? value / k_ticks_per_s : value);
  }
  return values;
}

std::vector<double> round_marks(double low, double high) {
  constexpr double k_wanted = 5;
  const double rough = (high - low) / k_wanted;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0}) {
    if (step < rough) {
      step = power * factor;
    }
  }
  std::vector<double> marks;
  const double least = std::ceil(low / step - 1e-9);
  for (double mark = least; mark * step <= high + 1e-9 * step; ++mark) {
    marks.push_back(mark == 0 ? 0 : mark * step);
  }
  return marks;
}

MapDrawing drawing_of(const Map& map, const PixelFacts& facts, const std::string& scene) {
  std::vector<double> values = told_values(map, facts);
  MapDrawing drawing;
  drawing.width = facts.zone.width;
  drawing.height = facts.zone.height;
  drawing.title = map.title;
  drawing.subtitle = place_of(facts, scene);
  if (map.names != nullptr && (facts.*map.names).size() <= k_most_names) {
    drawing.names = facts.*map.names;
  }
  auto [low, high] = range_of(values, map.kind != MapKind::number || map.unit != "1");
  const Scale scale = scale_of(map, high);
  for (const double value : values) {
    drawing.values.push_back(static_cast<float>(value * scale.factor));
  }
  low *= scale.factor;
  high *= scale.factor;
  drawing.low = static_cast<float>(low);
  drawing.high = static_cast<float>(high);
  if (drawing.names.empty()) {
    drawing.unit = map.unit == "1" ? "" : scale.prefix + map.unit;
    for (const double mark : round_marks(low, high)) {
      const bool is_whole = map.kind == MapKind::count || map.kind == MapKind::name;
      if (!is_whole || mark == std::floor(mark)) {
        drawing.ticks.push_back({static_cast<float>(mark), fmt::format("{:.6g}", mark)});
      }
    }
  }
  return drawing;
}

std::string map_picture(const Map& map, const PixelFacts& facts, const std::string& scene) {
  DrawnPicture drawn;
  const std::string error = codec().draw(drawing_of(map, facts, scene), drawn);
  if (!error.empty()) {
    throw std::runtime_error("map " + map.name + ": " + error);
  }
  constexpr int k_channels = 3;
  return encode({static_cast<std::uint32_t>(drawn.width), static_cast<std::uint32_t>(drawn.height),
                 k_channels, 8, std::move(drawn.channels)});
}

}  // namespace maquette::sim
