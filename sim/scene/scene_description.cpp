#include "sim/scene/scene_description.hpp"

#include <string>
#include <unordered_set>
#include <utility>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/fields/key_list.hpp"
#include "sim/scene/object_description.hpp"
#include "sim/scene/scene_checks.hpp"
#include "sim/scene/scene_fields.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"

namespace maquette::sim {
namespace {

/// As many lights or surfaces as a board's database can number, in 16 bits of which some numbers
/// have a meaning of their own; nodes and parameters have 32 bits.
constexpr std::size_t k_most_named = 65'000;

template <class Visitor>
void declare_named(Visitor& visitor, Light& light) {
  declare_light(visitor, light);
}

template <class Visitor>
void declare_named(Visitor& visitor, Surface& surface) {
  declare_surface(visitor, surface);
}

void finish_named(Light& light, const YamlEntry& entry) { check_light(light, entry.value); }

void finish_named(Surface& surface, const YamlEntry& entry) {
  surface.position_in_file = entry.place.position();
  check_surface(surface, entry.value);
}

/// A mapping from names to lights or surfaces.
template <class Element>
struct NamedType {
  [[nodiscard]] static std::vector<Element> read(const YamlNode& node, std::string_view name) {
    check_mapping(node, name);
    if (node.entries.size() > k_most_named) {
      throw DescriptionError(node.place.position(),
                             std::string{name} + ": " + std::to_string(node.entries.size()) +
                                 " are given; up to " + std::to_string(k_most_named) +
                                 " are allowed");
    }
    std::vector<Element> elements;
    elements.reserve(node.entries.size());
    for (const YamlEntry& entry : node.entries) {
      check_name(entry.key, entry.place, name);
      Element& element = elements.emplace_back();
      element.name = entry.key;
      FieldReader reader{entry.value, entry.key};
      declare_named(reader, element);
      reader.finish();
      finish_named(element, entry);
    }
    return elements;
  }

  [[nodiscard]] static YamlNode write(const std::vector<Element>& elements) {
    YamlNode mapping = yaml_mapping();
    for (Element element : elements) {
      FieldWriter writer;
      declare_named(writer, element);
      append(mapping, element.name, writer.take());
    }
    return mapping;
  }
};

/// The object tree, whose surfaces are among those of the scene.
struct ObjectType {
  const std::vector<Surface>& surfaces;

  [[nodiscard]] Object read(const YamlNode& node, std::string_view /*name*/) const {
    std::unordered_set<std::string_view> names;
    for (const Surface& surface : surfaces) {
      names.insert(surface.name);
    }
    return read_object(node, names);
  }

  [[nodiscard]] static YamlNode write(const Object& object) { return write_object(object); }
};

/// What a scene holds besides its plain parameters.
template <class Visitor>
void declare_content(Visitor& visitor, Scene& scene) {
  visitor.field({"lights", "by their names"}, scene.lights, NamedType<Light>{});
  visitor.field({"surfaces", "by their names"}, scene.surfaces, NamedType<Surface>{});
  visitor.field(required("object", "tree of primitives and operators"), scene.object,
                ObjectType{scene.surfaces});
}

template <class Element>
void list_named(std::vector<ParameterRow>& rows, const std::string& prefix, Element element) {
  ParameterTable table{prefix + element.name + "."};
  ParameterTable defaults{prefix + element.name + "."};
  Element standard;
  declare_named(table, element);
  declare_named(defaults, standard);
  for (ParameterRow& row : with_defaults(table.rows(), defaults.rows())) {
    rows.push_back(std::move(row));
  }
}

}  // namespace

Scene read_scene(const YamlNode& root) {
  Scene scene;
  FieldReader reader{root, "scene"};
  declare_scene(reader, scene);
  declare_content(reader, scene);
  reader.allow("machine");
  reader.finish();
  check_view(scene.view, nearest_node(root, "view"));
  check_sheets(scene);
  check_ray_tree(scene, root);
  if (scene.samples) {
    check_samples(*scene.samples, *root.find("samples"));
  }
  return scene;
}

YamlNode write_scene(Scene scene) {
  FieldWriter writer;
  declare_scene(writer, scene);
  declare_content(writer, scene);
  return writer.take();
}

std::vector<ParameterRow> list_parameters(const Scene& scene) {
  Scene plain;  // without the object tree, which is large
  plain.name = scene.name;
  plain.paper_time = scene.paper_time;
  plain.extents = scene.extents;
  plain.view = scene.view;
  plain.ambient = scene.ambient;
  plain.background = scene.background;
  plain.shadows = scene.shadows;
  plain.ray_tree = scene.ray_tree;
  plain.samples = scene.samples;
  Scene standard;
  ParameterTable table;
  ParameterTable defaults;
  declare_scene(table, plain);
  declare_scene(defaults, standard);
  std::vector<ParameterRow> rows = with_defaults(table.rows(), defaults.rows());
  for (const Light& light : scene.lights) {
    list_named(rows, "lights.", light);
  }
  for (const Surface& surface : scene.surfaces) {
    list_named(rows, "surfaces.", surface);
  }
  return rows;
}

std::vector<std::string_view> scene_keys() {
  KeyList list;
  Scene scene;
  declare_scene(list, scene);
  declare_content(list, scene);
  std::vector<std::string_view> keys = list.keys();
  keys.emplace_back("machine");
  return keys;
}

}  // namespace maquette::sim
