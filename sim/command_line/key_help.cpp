#include "sim/command_line/key_help.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/machine/cost_fields.hpp"
#include "sim/machine/unit_fields.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/scene_fields.hpp"
#include "sim/sweep/study_fields.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {

namespace {

/// A part of descriptions other than a primitive.
struct Part {
  const char* name;
  const char* sentence;
  std::vector<KeyRow> (*keys)();
  const char* example;
};

template <class Value, class Declare>
std::vector<KeyRow> listed(Declare declare) {
  KeyTable table;
  Value value{};
  declare(table, value);
  return table.rows();
}

std::vector<KeyRow> view_keys() {
  return listed<View>([](KeyTable& table, View& view) { declare_view(table, view); });
}

std::vector<KeyRow> light_keys() {
  return listed<Light>([](KeyTable& table, Light& light) { declare_light(table, light); });
}

std::vector<KeyRow> surface_keys() {
  return listed<Surface>(
      [](KeyTable& table, Surface& surface) { declare_surface(table, surface); });
}

std::vector<KeyRow> study_keys() {
  return listed<Study>([](KeyTable& table, Study& study) { declare_study(table, study); });
}

std::vector<KeyRow> plot_keys() {
  return listed<Plot>([](KeyTable& table, Plot& plot) { declare_element(table, plot); });
}

std::vector<KeyRow> column_keys() {
  return listed<DerivedColumn>(
      [](KeyTable& table, DerivedColumn& column) { declare_element(table, column); });
}

std::vector<KeyRow> place_keys() {
  const std::string list = "a step, or steps in a list, which are applied in their order";
  return {{"translate", "[x, y, z]", {}, false, "moves by so much, in scene units; " + list},
          {"scale", "a number or [x, y, z]", {}, false, "other than 0, about the origin"},
          {"rotate",
           "{axis: [x, y, z], angle: 30 deg}",
           {},
           false,
           "about an axis through the origin, counterclockwise against its direction"},
          {"matrix", "twelve numbers", {}, false, "the rows of a 3 x 4 matrix"}};
}

std::vector<KeyRow> operator_keys() {
  const std::string objects = "a list of two or more objects";
  return {
      {"union", objects, {}, false, "what is in one of them at least"},
      {"intersection", objects, {}, false, "what is in all of them"},
      {"difference", objects, {}, false, "what is in the first and in none of the others"},
      {"name", "a name", {}, false, "of the object; may be left out"},
      {"surface", "the name of a surface", {}, false, "of its bodies that name none"},
      {"place", "as of `describe --keys place`", {}, false, "in the frame of the object above"}};
}

/// The keys of a cost table, of which each operation has the same: told once, as OPERATION.
std::vector<KeyRow> of_one_operation(std::vector<KeyRow> rows, std::size_t first) {
  const std::string name = firmware::k_operation_names[first];
  std::vector<KeyRow> kept;
  for (KeyRow& row : rows) {
    const bool is_operation = row.path.compare(0, name.size(), name) == 0 &&
                              (row.path.size() == name.size() || row.path[name.size()] == '.');
    if (is_operation) {
      row.path.replace(0, name.size(), "OPERATION");
    }
    const bool is_of_another =
        row.path.find('.') != std::string::npos || row.type == "a group of keys";
    if (is_operation || !is_of_another) {
      kept.push_back(std::move(row));
    }
  }
  return kept;
}

std::vector<KeyRow> arithmetic_keys() {
  return of_one_operation(listed<CostTables>([](KeyTable& table, CostTables& tables) {
                            models::ArithmeticCosts costs;
                            declare_arithmetic(table, costs, tables);
                          }),
                          0);
}

std::vector<KeyRow> program_keys() {
  return of_one_operation(listed<CostTables>([](KeyTable& table, CostTables& tables) {
                            models::ArithmeticCosts costs;
                            declare_program(table, costs, tables);
                          }),
                          firmware::k_arithmetic_count);
}

/// Its cost tables have parts of their own.
std::vector<KeyRow> unit_keys() {
  std::vector<KeyRow> rows = listed<CostTables>([](KeyTable& table, CostTables& tables) {
    models::FunctionUnitParameters unit;
    declare_unit_kind(table, unit, tables);
  });
  rows.erase(
      std::remove_if(rows.begin(), rows.end(),
                     [](const KeyRow& row) { return row.path.find('.') != std::string::npos; }),
      rows.end());
  return rows;
}

constexpr Part k_parts[] = {
    {"view", "Where the observer of a scene stands, `view`", view_keys,
     "view: {eye: [0, -6, 3], target: [0, 0, 0], field_of_view: 30 deg}"},
    {"light", "A light of a scene, in `lights` by its name", light_keys,
     "lights: {key: {position: [5, -6, 8], intensity: [1, 1, 1]}}"},
    {"surface", "A surface of a scene, in `surfaces` by its name", surface_keys,
     "surfaces: {red: {diffuse: [0.8, 0.1, 0.1], specular: 0.2, index: 1.5}}"},
    {"operator", "An operator of a scene's object tree, which combines objects", operator_keys,
     "object: {difference: [{box: {size: [1, 1, 1]}}, {sphere: {radius: 0.6}}], surface: red}"},
    {"place", "Where an object stands in the frame of the object above it, `place`", place_keys,
     "object: {sphere: {radius: 1}, surface: red, place: [{scale: 2}, {translate: [0, 0, 1]}]}"},
    {"arithmetic",
     "A cost table of arithmetic, the file that `arithmetic` of a board or unit names; OPERATION "
     "is "
     "each of the operations in models/arithmetic",
     arithmetic_keys,
     "multiply: {clocks: 290, reads: 31, writes: 7, called: false, mark: I, source: an estimate}"},
    {"program",
     "A cost table of the program's events, the file that `program` of a board or unit names; "
     "OPERATION "
     "is each of the events in models/program",
     program_keys, "ray: {clocks: 2500, reads: 400, writes: 200, mark: I, source: an estimate}"},
    {"unit",
     "Function units of a kind (extents, intersection, combination, photometry, secondary_rays), "
     "in `units` of a machine by its name; arithmetic and program are cost tables or their names",
     unit_keys, "units: {intersection: {number: 4, clock: 64 MHz}}"},
    {"study", "A study, the file of `sweep --sweep`", study_keys,
     "{name: boards, scene: photo4, vary: {processors: 1..8}}"},
    {"plot", "A plot of a study, in its list `plots`", plot_keys,
     "plots: [{x: processors, y: frame.time_s, log_x: true}]"},
    {"column", "A column that the table of a study gets besides, in its list `columns`",
     column_keys,
     "columns: [{name: speed_up, kind: speed_up, of: frame.time_s, over: processors}]"},
};

std::string text_of(const std::string& title, const std::vector<KeyRow>& rows,
                    const std::string& example) {
  return title + "\n\n" + key_list(rows) + "\nExample: " + example + "\n";
}

const Part& find_part(const std::string& part) {
  const auto* const found = std::find_if(std::begin(k_parts), std::end(k_parts),
                                         [&part](const Part& row) { return row.name == part; });
  if (found == std::end(k_parts)) {
    const std::vector<std::string> names = explained_parts();
    throw DescriptionError(SourcePosition{"--keys " + part, 1, 1},
                           "unknown part; " + allowed_names(part, {names.begin(), names.end()}));
  }
  return *found;
}

}  // namespace

std::vector<std::string> explained_parts() {
  std::vector<std::string> names;
  for (const PrimitiveDescription* primitive : primitive_table()) {
    names.emplace_back(primitive->name);
  }
  for (const Part& part : k_parts) {
    names.emplace_back(part.name);
  }
  return names;
}

std::vector<KeyRow> keys_of_part(const std::string& part) {
  const PrimitiveDescription* primitive = find_primitive(part);
  return primitive != nullptr ? keys_of(*primitive) : find_part(part).keys();
}

std::string key_help(const std::string& part) {
  if (const PrimitiveDescription* primitive = find_primitive(part)) {
    const std::string example =
        fmt::format("object: {{{}: {}, surface: red}}", part, primitive->example);
    return text_of("The primitive `" + part + "` of a scene's object tree", keys_of_part(part),
                   example) +
           "In a scene: scenes/primitives/" + part + ".yaml\n";
  }
  const Part& found = find_part(part);
  return text_of(found.sentence, found.keys(), found.example);
}

}  // namespace maquette::sim
