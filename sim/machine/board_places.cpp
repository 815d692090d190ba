#include "sim/machine/board_places.hpp"

#include <utility>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"

namespace maquette::sim {

BoardPlaces to_board_places(const PlaceList& boards) {
  BoardPlaces result;
  result.count = static_cast<int>(boards.size());
  result.request_level = boards.empty() ? 0 : boards.front().level;
  for (int i = 0; i < result.count; ++i) {
    const models::BusMasterPlace& place = boards[static_cast<std::size_t>(i)];
    if (place.level != boards.front().level || place.position != i) {
      result.request_level.reset();
      result.places = boards;
      break;
    }
  }
  return result;
}

PlaceList to_place_list(const BoardPlaces& places) {
  if (places.places) {
    return *places.places;
  }
  PlaceList result;
  for (int i = 0; i < places.count; ++i) {
    result.push_back({places.request_level.value_or(0), i});
  }
  return result;
}

PlaceList PlaceListType::read(const YamlNode& node, std::string_view name) {
  if (node.kind != YamlKind::sequence || node.items.empty()) {
    throw DescriptionError(node.place.position(), std::string{name} + ": " + node.kind_name() +
                                                      " stands here; a list of {level, position} "
                                                      "is allowed, one per board");
  }
  PlaceList result;
  for (const YamlNode& item : node.items) {
    FieldReader reader{item, name};
    declare_place(reader, result.emplace_back(), true);
    reader.finish();
  }
  return result;
}

YamlNode PlaceListType::write(const PlaceList& value) {
  std::vector<YamlNode> items;
  for (models::BusMasterPlace place : value) {
    FieldWriter writer;
    declare_place(writer, place, true);
    items.push_back(writer.take());
  }
  return yaml_sequence(std::move(items));
}

}  // namespace maquette::sim
