#pragma once

#include <optional>
#include <vector>

#include "models/machine_parameters.hpp"
#include "sim/description/declaration.hpp"
#include "sim/description/value_types.hpp"

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
  [[nodiscard]] PlaceList read(const YamlNode& node, std::string_view name) const;
  [[nodiscard]] YamlNode write(const PlaceList& value) const;
  [[nodiscard]] std::string unit() const { return "none"; }
  [[nodiscard]] std::string range() const { return "level 0 to 4, position 0 to 255"; }
};

/// The fields of one master's place.
template <class Visitor>
void declare_place(Visitor& visitor, models::BusMasterPlace& place) {
  visitor.field(required("level", "request level; 4 is the highest", "VM02 data sheet p. 2-53 [R]"),
                place.level, WholeType{WholeDimension::count, {0, 4}});
  visitor.field(required("position", "in the daisy chain of the level; 0 is nearest to the arbiter",
                         "principle of VMEbus [I]"),
                place.position, WholeType{WholeDimension::count, {0, 255}});
}

}  // namespace maquette::sim
