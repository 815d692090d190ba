#pragma once

#include <optional>
#include <vector>

#include "models/machine/machine_parameters.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"

namespace maquette::sim {

using PlaceList = std::vector<models::BusMasterPlace>;

/// How a description says where the boards sit on the bus: all of them strapped to one request
/// level and chained in board order, or each in its own place.
struct BoardPlaces {
  int count = 4;
  std::optional<int> request_level = 0;
  std::optional<PlaceList> places;
};

[[nodiscard]] BoardPlaces to_board_places(const PlaceList& boards);
[[nodiscard]] PlaceList to_place_list(const BoardPlaces& places);

/// A list of {level, position}.
struct PlaceListType {
  [[nodiscard]] static PlaceList read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const PlaceList& value);
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "level 0 to 4, position 0 to 255"; }
};

/// The fields of one master's place.
template <class Visitor>
void declare_place(Visitor& visitor, models::BusMasterPlace& place, bool is_required) {
  visitor.field(
      {"level", "request level; 4 is the highest", "VM02 data sheet p. 2-53 [R]", is_required},
      place.level, WholeType{WholeDimension::count, {0, 4}});
  visitor.field({"position", "in the daisy chain of the level; 0 is nearest to the arbiter",
                 "principle of VMEbus [I]", is_required},
                place.position, WholeType{WholeDimension::count, {0, 255}});
}

}  // namespace maquette::sim
