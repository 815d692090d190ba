#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/maps/map_reading.hpp"

namespace maquette::sim {

/// The maps that a run makes for its page, beside those that it is asked for.
[[nodiscard]] const std::vector<std::string>& page_maps();

/// The maps as layers of the picture, those left out that are the same everywhere zero: of each its
/// name, title and unit, and a PNG whose colours are its values: 24-bit numbers of which one is
/// `step`, from `low`; all bits set where a pixel has no value. Counts and names are exact, other
/// values to some 6e-8 of their range.
[[nodiscard]] nlohmann::ordered_json layers_of(const ReadMaps& maps);

}  // namespace maquette::sim
