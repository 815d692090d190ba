#pragma once

#include <string>
#include <vector>

#include "models/board/pixel_rectangle.hpp"
#include "sim/maps/map_table.hpp"

namespace maquette::sim {

/// A map as a file has it: times in seconds, not a number where a pixel has no value.
struct ReadMap {
  const Map* map;
  std::vector<double> values;  ///< row by row of the zone
  std::string names;           ///< of a MapKind::name, as they are listed: "red, blue"
};

/// The maps of a file, in the order of the table.
struct ReadMaps {
  models::PixelRectangle zone;
  std::vector<ReadMap> maps;
};

/// Reads what encode_maps has written. `name` is that of the file, for error messages. Throws
/// DescriptionError.
[[nodiscard]] ReadMaps decode_maps(const std::string& bytes, const std::string& name);

}  // namespace maquette::sim
