#include "sim/record/recorded_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "firmware_version.hpp"
#include "sim/database/board_image.hpp"
#include "sim/report/digest.hpp"

namespace maquette::sim {

std::string RecordKey::name() const {
  const std::string all = fmt::format("{} {} {} {} {}", scene_sha1, firmware, format.width,
                                      format.height, format.has_depth);
  return sha1_of(all.data(), all.size());
}

namespace {

/// A scene as memory holds it; where its arrays are is no matter.
std::vector<unsigned char> scene_image(const PackedScene<float>& scene) {
  constexpr auto k_format = firmware::NumberFormat::ieee_single;
  std::vector<unsigned char> image = database_image(scene, k_format);
  firmware::Database<float> header = scene.database();
  header.leaves = nullptr;
  header.composites = nullptr;
  header.parameters = nullptr;
  header.surfaces = nullptr;
  header.lights = nullptr;
  header.surface_ambients = nullptr;
  header.light_shapes = nullptr;
  header.leaf_textures = nullptr;
  header.textures = nullptr;
  header.texels = nullptr;
  const std::size_t arrays = image.size();
  image.resize(arrays +
               static_cast<std::size_t>(firmware::board_bytes<firmware::Database<float>>()));
  BoardWriter(image, k_format).write(static_cast<std::uint32_t>(arrays), &header, 1);
  return image;
}

}  // namespace

bool legs_make_pixels(const RecordedFrame& frame) {
  if (!frame.has_legs()) {
    return false;
  }
  for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
    firmware::LongWork sum{};
    for (const models::PixelLeg& leg : frame.legs.legs(i)) {
      for (int k = 0; k < firmware::k_operation_count; ++k) {
        sum.counts[k] += leg.work.counts[k];
      }
    }
    if (!std::equal(std::begin(sum.counts), std::end(sum.counts),
                    std::begin(frame.pixels[i].work.counts))) {
      return false;
    }
  }
  return true;
}

RecordKey record_key_of(const PackedScene<float>& scene) {
  const firmware::Database<float> database = scene.database();
  std::vector<unsigned char> image = scene_image(scene);
  if (scene.extents != Extents::all) {
    image.push_back(static_cast<unsigned char>(scene.extents));
  }
  return {sha1_of(image.data(), image.size()),
          firmware::k_firmware_version,
          {database.observer.columns, database.observer.rows, database.needs.depth}};
}

}  // namespace maquette::sim
