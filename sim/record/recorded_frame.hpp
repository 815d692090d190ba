#pragma once

#include <string>
#include <vector>

#include "firmware/arithmetic/work.hpp"
#include "firmware/database.hpp"
#include "models/board/allotment.hpp"
#include "models/board/pixel_source.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/record/function_work.hpp"
#include "sim/record/leg_table.hpp"

namespace maquette::sim {

/// What the work of a frame depends on: nothing of the machine but the format of its picture.
struct RecordKey {
  std::string scene_sha1;  ///< of the database as a board holds it, 40 hexadecimal digits
  std::string firmware;    ///< version of the firmware, as long
  PictureFormat format{};

  /// One name for all of it, 40 hexadecimal digits.
  [[nodiscard]] std::string name() const;
};

/// A frame that was synthesised once, for any machine: the colour, rays and work of every pixel of
/// the useful zone.
struct RecordedFrame {
  RecordKey key;
  models::PixelRectangle useful_zone;
  firmware::Work preprocessing{};
  FrameWork by_function;
  std::vector<models::SynthesizedPixel> pixels;  ///< row-major in the useful zone
  std::vector<FunctionCounts> functions;         ///< of each pixel, for the eye; not read back
  LegTable legs;                                 ///< of each pixel, where they are told

  /// The pixel at a position of the useful zone.
  [[nodiscard]] const models::SynthesizedPixel& at(const models::PixelPosition& position) const {
    return pixels[place_of(position)];
  }

  /// Its place among the pixels.
  [[nodiscard]] std::size_t place_of(const models::PixelPosition& position) const {
    const auto row = static_cast<std::size_t>(position.row - useful_zone.row0);
    const auto column = static_cast<std::size_t>(position.column - useful_zone.column0);
    return row * static_cast<std::size_t>(useful_zone.width) + column;
  }

  /// Whether it tells the legs of its pixels.
  [[nodiscard]] bool has_legs() const { return legs.pixels() == pixels.size(); }
};

/// Whether it has the legs of each pixel, and they sum to its work.
bool legs_make_pixels(const RecordedFrame& frame);

/// The key of a scene as this program's firmware would synthesise it.
RecordKey record_key_of(const PackedScene<float>& scene);

}  // namespace maquette::sim
