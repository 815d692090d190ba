#include "sim/scene/object_description.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/scene/placement.hpp"
#include "sim/scene/scene_fields.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {
namespace {

struct KindName {
  std::string_view name;
  ObjectKind kind;
};

constexpr std::array<KindName, 13> k_kinds = {{{"half_space", ObjectKind::half_space},
                                               {"box", ObjectKind::box},
                                               {"sphere", ObjectKind::sphere},
                                               {"cylinder", ObjectKind::cylinder},
                                               {"cone", ObjectKind::cone},
                                               {"revolution", ObjectKind::revolution},
                                               {"terrain", ObjectKind::terrain},
                                               {"algebraic", ObjectKind::algebraic},
                                               {"prism", ObjectKind::prism},
                                               {"patches", ObjectKind::patches},
                                               {"union", ObjectKind::union_of},
                                               {"intersection", ObjectKind::intersection},
                                               {"difference", ObjectKind::difference}}};

constexpr std::string_view k_kind_list =
    "half_space, box, sphere, cylinder, cone, revolution, terrain, algebraic, prism, patches, "
    "union, "
    "intersection, difference";

bool is_operator(ObjectKind kind) {
  return kind == ObjectKind::union_of || kind == ObjectKind::intersection ||
         kind == ObjectKind::difference;
}

const KindName* find_kind(std::string_view name) {
  const auto* found = std::find_if(k_kinds.begin(), k_kinds.end(),
                                   [&](const KindName& kind) { return kind.name == name; });
  return found == k_kinds.end() ? nullptr : found;
}

[[noreturn]] void fail(const YamlPlace& place, const std::string& message) {
  throw DescriptionError(place.position(), message);
}

/// What a node knows from the nodes above it.
struct Surroundings {
  Placement to_scene{1.0};
  bool has_surface = false;
  int depth = 1;
};

class ObjectReader {
 public:
  explicit ObjectReader(const std::unordered_set<std::string_view>& surfaces)
      : surfaces_(surfaces) {}

  [[nodiscard]] Object read(const YamlNode& node, const Surroundings& above) const;

 private:
  [[nodiscard]] std::string read_surface(const YamlNode& node) const;
  void read_children(const YamlEntry& entry, const Surroundings& above, Object& object) const;

  const std::unordered_set<std::string_view>& surfaces_;
};

/// The entry that says what the object is.
const YamlEntry& kind_entry(const YamlNode& node) {
  const YamlEntry* found = nullptr;
  for (const YamlEntry& entry : node.entries) {
    if (find_kind(entry.key) == nullptr) {
      continue;
    }
    if (found != nullptr) {
      fail(entry.place, "object: it is a " + found->key + " already; one of " +
                            std::string{k_kind_list} + " is allowed");
    }
    found = &entry;
  }
  if (found == nullptr) {
    fail(node.place,
         "object: what it is is missing; one of " + std::string{k_kind_list} + " is allowed");
  }
  return *found;
}

void check_object_keys(const YamlNode& node) {
  std::vector<std::string_view> allowed{"name", "surface", "place"};
  for (const KindName& kind : k_kinds) {
    allowed.push_back(kind.name);
  }
  check_keys(node, "object", allowed);
}

void check_sphere(const YamlNode& node) {
  const YamlNode* radius = node.find("radius");
  const YamlNode* radii = node.find("radii");
  if ((radius == nullptr) == (radii == nullptr)) {
    fail(radii == nullptr ? node.place : radii->place,
         "sphere: one of radius, radii is allowed and needed");
  }
}

void read_primitive(const YamlEntry& entry, Object& object) {
  FieldReader reader{entry.value, entry.key};
  declare_primitive(reader, object);
  reader.finish();
  if (object.kind == ObjectKind::sphere) {
    check_sphere(entry.value);
  } else if (const auto* revolution = std::get_if<RevolutionShape>(&object.shape)) {
    check_revolution(*revolution, entry.value);
  } else if (const auto* terrain = std::get_if<TerrainShape>(&object.shape)) {
    check_terrain(*terrain, entry.value);
  } else if (const auto* algebraic = std::get_if<AlgebraicShape>(&object.shape)) {
    check_algebraic(*algebraic, entry.value);
  } else if (const auto* prism = std::get_if<PrismShape>(&object.shape)) {
    check_prism(*prism, entry.value);
  } else if (const auto* patches = std::get_if<PatchesShape>(&object.shape)) {
    check_patches(*patches, entry.value);
  }
}

std::string ObjectReader::read_surface(const YamlNode& node) const {
  std::string name = TextType::read(node, "surface");
  if (surfaces_.find(name) == surfaces_.end()) {
    std::vector<std::string_view> allowed{surfaces_.begin(), surfaces_.end()};
    std::sort(allowed.begin(), allowed.end());
    fail(node.place,
         "surface: `" + name + "` is not among the surfaces; " + allowed_names(name, allowed));
  }
  return name;
}

void ObjectReader::read_children(const YamlEntry& entry, const Surroundings& above,
                                 Object& object) const {
  if (entry.value.kind != YamlKind::sequence || entry.value.items.size() < 2) {
    fail(entry.value.place, entry.key + ": a list of two or more objects is allowed");
  }
  object.children.reserve(entry.value.items.size());
  for (const YamlNode& child : entry.value.items) {
    object.children.push_back(read(child, above));
  }
}

Object ObjectReader::read(const YamlNode& node, const Surroundings& above) const {
  check_mapping(node, "object");
  check_object_keys(node);
  if (above.depth > k_object_depth_limit) {
    fail(node.place, "object: nested deeper than " + std::to_string(k_object_depth_limit) +
                         " levels of objects");
  }
  const YamlEntry& entry = kind_entry(node);
  Object object;
  object.kind = find_kind(entry.key)->kind;
  object.position_in_file = node.place.position();
  Surroundings here{above.to_scene, above.has_surface, above.depth + 1};
  if (const YamlNode* name = node.find("name")) {
    object.name = TextType::read(*name, "name");
    check_name(object.name, name->place, "name");
  }
  if (const YamlNode* surface = node.find("surface")) {
    object.surface = read_surface(*surface);
    here.has_surface = true;
  }
  if (const YamlNode* place = node.find("place")) {
    object.placement = read_placement(*place);
    here.to_scene = concatenated(above.to_scene, object.placement);
    if (is_singular(here.to_scene)) {
      fail(place->place, "place: with those of the objects above it flattens the object");
    }
  }
  if (is_operator(object.kind)) {
    read_children(entry, here, object);
    return object;
  }
  read_primitive(entry, object);
  if (!here.has_surface) {
    fail(node.place, "object: neither it nor an object above it has a surface");
  }
  return object;
}

}  // namespace

Object read_object(const YamlNode& node, const std::unordered_set<std::string_view>& surfaces) {
  return ObjectReader{surfaces}.read(node, Surroundings{});
}

YamlNode write_object(const Object& object) {
  const auto* kind = std::find_if(k_kinds.begin(), k_kinds.end(), [&](const KindName& candidate) {
    return candidate.kind == object.kind;
  });
  YamlNode node = yaml_mapping();
  if (!object.name.empty()) {
    append(node, "name", yaml_scalar(object.name));
  }
  if (!object.surface.empty()) {
    append(node, "surface", yaml_scalar(object.surface));
  }
  if (object.placement != Placement{1.0}) {
    append(node, "place", write_placement(object.placement));
  }
  if (is_operator(object.kind)) {
    std::vector<YamlNode> children;
    children.reserve(object.children.size());
    for (const Object& child : object.children) {
      children.push_back(write_object(child));
    }
    append(node, kind->name, yaml_sequence(std::move(children)));
    return node;
  }
  Object primitive = object;
  FieldWriter writer;
  declare_primitive(writer, primitive);
  append(node, kind->name, writer.take());
  return node;
}

}  // namespace maquette::sim
