#include "sim/sweep/study_types.hpp"

#include <string>

#include "sim/fields/field_reader.hpp"

namespace maquette::sim {

std::vector<Override> ChangesType::read(const YamlNode& node, std::string_view name) {
  check_mapping(node, name);
  std::vector<Override> changes;
  for (const YamlEntry& entry : node.entries) {
    changes.push_back({parse_path(entry.key, entry.place), entry.value});
  }
  return changes;
}

YamlNode ChangesType::write(const std::vector<Override>& changes) {
  YamlNode mapping = yaml_mapping();
  for (const Override& change : changes) {
    append(mapping, path_of(change.path), change.value);
  }
  return mapping;
}

std::vector<Axis> AxesType::read(const YamlNode& node, std::string_view name) {
  check_mapping(node, name);
  std::vector<Axis> axes;
  for (const YamlEntry& entry : node.entries) {
    axes.push_back(read_axis(entry.key, entry.place, entry.value));
  }
  return axes;
}

YamlNode AxesType::write(const std::vector<Axis>& axes) {
  YamlNode mapping = yaml_mapping();
  for (const Axis& axis : axes) {
    append(mapping, axis.path, write_axis(axis));
  }
  return mapping;
}

}  // namespace maquette::sim
