#pragma once

#include <string>
#include <vector>

#include "sim/maps/map_table.hpp"
#include "sim/report/run_directory.hpp"

namespace maquette::sim {

/// The attribute that lists the maps of a file by their names: "time, board".
inline constexpr const char* k_maps_attribute = "maps";

/// The maps as one OpenEXR file whose data window is the useful zone: a channel for each by its
/// name, whole numbers for counts and floating point for the others (not a number where a pixel has
/// no value); unit, title and names of NAME in the attributes `unit.NAME`, `title.NAME` and
/// `names.NAME`. Throws std::runtime_error.
std::string encode_maps(const std::vector<Map>& maps, const PixelFacts& facts);

/// `maps.exr`, and a `map-NAME.png` for each that is `drawn`; nothing without maps or a useful
/// zone.
std::vector<NamedContent> map_files(const std::vector<Map>& maps, const std::vector<Map>& drawn,
                                    const PixelFacts& facts, const std::string& scene);

}  // namespace maquette::sim
