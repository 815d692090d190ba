#pragma once

#include <string>
#include <vector>

#include "sim/maps/map_table.hpp"
#include "sim/picture_module/map_drawing.hpp"

namespace maquette::sim {

/// The values of a map as they are told (times in seconds), row by row of the useful zone.
std::vector<double> told_values(const Map& map, const PixelFacts& facts);

/// Round numbers within a range, from its lower to its upper end, some five of them.
std::vector<double> round_marks(double low, double high);

/// The map as it is drawn: its scale begins at zero where no value is below.
MapDrawing drawing_of(const Map& map, const PixelFacts& facts, const std::string& scene);

/// The bytes of a PNG file. Throws std::runtime_error.
std::string map_picture(const Map& map, const PixelFacts& facts, const std::string& scene);

}  // namespace maquette::sim
