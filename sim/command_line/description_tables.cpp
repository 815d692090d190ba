#include "sim/command_line/description_tables.hpp"

#include <algorithm>

#include "sim/command_line/key_help.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/maps/map_table.hpp"
#include "sim/report/scalar_statistics.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {

namespace {

Table table_of(const std::vector<std::string>& columns) {
  Table table;
  for (const std::string& name : columns) {
    table.columns.push_back({name, "", ""});
  }
  return table;
}

Table table_of_parameters() {
  return table_of({"path", "value", "unit", "default", "allowed", "meaning", "source"});
}

void add(Table& table, const std::vector<ParameterRow>& rows) {
  for (const ParameterRow& row : rows) {
    table.rows.push_back(
        {row.path, row.value, row.unit, row.default_value, row.range, row.sentence, row.source});
  }
}

bool is_plain(const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::null:
    case YamlKind::scalar:
      return true;
    case YamlKind::sequence:
      return std::all_of(node.items.begin(), node.items.end(), is_plain);
    case YamlKind::mapping:
      break;
  }
  return false;
}

/// What holds no keys is a value; lists are followed by their numbers.
void add_values(Table& table, const std::string& path, const YamlNode& node) {
  if (is_plain(node)) {
    table.rows.push_back({path, write_flow(node)});
    return;
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    add_values(table, path + "." + std::to_string(i), node.items[i]);
  }
  for (const YamlEntry& entry : node.entries) {
    add_values(table, path + "." + entry.key, entry.value);
  }
}

}  // namespace

Table parameter_table(const Machine& machine) {
  Table table = table_of_parameters();
  add(table, with_defaults(list_parameters(machine), list_parameters(default_machine())));
  return table;
}

Table parameter_table(const Description& description) {
  Table table = table_of_parameters();
  add(table, list_parameters(description.scene));
  for (std::vector<std::string>& row :
       object_table(parse_yaml(description.input_files.front())).rows) {
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  add(table,
      with_defaults(list_parameters(description.machine), list_parameters(default_machine())));
  return table;
}

Table object_table(const YamlNode& scene) {
  constexpr const char* k_object = "object";
  Table table = table_of({"path", "value"});
  if (const YamlNode* object = scene.find(k_object)) {
    add_values(table, k_object, *object);
  }
  return table;
}

Table statistics_table() {
  Table table = table_of({"key", "unit", "meaning"});
  for (const ScalarStatistic& scalar : scalar_statistics({})) {
    table.rows.push_back({scalar.name, scalar.unit, scalar.sentence});
  }
  return table;
}

Table maps_table() {
  Table table = table_of({"name", "unit", "title"});
  for (const Map& map : all_maps()) {
    table.rows.push_back({map.name, map.unit, map.title});
  }
  return table;
}

Table keys_table(const std::string& part) {
  Table table = table_of({"key", "allowed", "default", "needed", "meaning"});
  for (const KeyRow& row : keys_of_part(part)) {
    table.rows.push_back(
        {row.path, row.type, row.default_value, row.required ? "yes" : "no", row.sentence});
  }
  return table;
}

}  // namespace maquette::sim
