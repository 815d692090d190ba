#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/maps/pixel_facts.hpp"

namespace maquette::sim {

/// What the values of a map are.
enum class MapKind {
  time,    ///< ticks, told in seconds
  count,   ///< whole numbers
  number,  ///< others
  name     ///< places in a list of names
};

/// Of each pixel a number, to be looked at as a picture.
struct Map {
  std::string name;  ///< as --map takes it; a channel of the OpenEXR file
  std::string unit;
  std::string title;
  MapKind kind;
  bool WantedFacts::*fact;  ///< that it is taken from
  /// Of the pixel with a place in the zone; not a number where there is none.
  std::function<double(const PixelFacts& facts, std::size_t pixel)> value;
  std::vector<std::string> PixelFacts::*names = nullptr;  ///< of a MapKind::name, if there are any
};

/// All maps: adding one is adding a row.
const std::vector<Map>& all_maps();

/// The maps that a command asks for, each once, in the order of the table. Throws DescriptionError
/// for a name that is none.
std::vector<Map> maps_named(const std::vector<std::string>& names);

/// What they are taken from.
WantedFacts facts_of(const std::vector<Map>& maps);

/// A list of all maps with their units, for people.
std::string describe_maps();

}  // namespace maquette::sim
