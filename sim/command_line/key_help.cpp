#include "sim/command_line/key_help.hpp"

#include <algorithm>

#include "sim/fields/key_table.hpp"
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

constexpr Part k_parts[] = {
    {"view", "Where the observer of a scene stands, `view`", view_keys,
     "view: {eye: [0, -6, 3], target: [0, 0, 0], field_of_view: 30 deg}"},
    {"light", "A light of a scene, in `lights` by its name", light_keys,
     "lights: {key: {position: [5, -6, 8], intensity: [1, 1, 1]}}"},
    {"surface", "A surface of a scene, in `surfaces` by its name", surface_keys,
     "surfaces: {red: {diffuse: [0.8, 0.1, 0.1], specular: 0.2, index: 1.5}}"},
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

std::string key_help(const std::string& part) {
  if (const PrimitiveDescription* primitive = find_primitive(part)) {
    return text_of("The primitive `" + part + "` of a scene's object tree", keys_of(*primitive),
                   "scenes/primitives/" + part + ".yaml");
  }
  const auto* const found = std::find_if(std::begin(k_parts), std::end(k_parts),
                                         [&part](const Part& row) { return row.name == part; });
  if (found == std::end(k_parts)) {
    const std::vector<std::string> names = explained_parts();
    throw DescriptionError(SourcePosition{"--keys " + part, 1, 1},
                           "unknown part; " + allowed_names(part, {names.begin(), names.end()}));
  }
  return text_of(found->sentence, found->keys(), found->example);
}

}  // namespace maquette::sim
