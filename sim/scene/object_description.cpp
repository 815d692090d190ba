#include "sim/scene/object_description.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "sim/fields/field_reader.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {
namespace {

using firmware::BooleanOperator;

struct OperatorName {
  std::string_view name;
  BooleanOperator combination;
};

constexpr OperatorName k_operators[] = {{"union", BooleanOperator::union_of},
                                        {"intersection", BooleanOperator::intersection},
                                        {"difference", BooleanOperator::difference}};

const OperatorName* find_operator(std::string_view name) {
  const auto* const found =
      std::find_if(std::begin(k_operators), std::end(k_operators),
                   [name](const OperatorName& each) { return each.name == name; });
  return found == std::end(k_operators) ? nullptr : found;
}

std::string_view name_of(BooleanOperator combination) {
  return std::find_if(
             std::begin(k_operators), std::end(k_operators),
             [combination](const OperatorName& each) { return each.combination == combination; })
      ->name;
}

/// The keys that say what an object is.
std::vector<std::string_view> kind_names() {
  std::vector<std::string_view> names;
  for (const PrimitiveDescription* primitive : primitive_table()) {
    names.push_back(primitive->name);
  }
  for (const OperatorName& each : k_operators) {
    names.push_back(each.name);
  }
  return names;
}

std::string kind_list() {
  std::string list;
  for (const std::string_view name : kind_names()) {
    list += (list.empty() ? "" : ", ") + std::string{name};
  }
  return list;
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
    if (find_primitive(entry.key) == nullptr && find_operator(entry.key) == nullptr) {
      continue;
    }
    if (found != nullptr) {
      fail(entry.place,
           "object: it is a " + found->key + " already; one of " + kind_list() + " is allowed");
    }
    found = &entry;
  }
  if (found == nullptr) {
    fail(node.place, "object: what it is is missing; one of " + kind_list() + " is allowed");
  }
  return *found;
}

void check_object_keys(const YamlNode& node) {
  std::vector<std::string_view> allowed{"name", "surface", "place"};
  const std::vector<std::string_view> kinds = kind_names();
  allowed.insert(allowed.end(), kinds.begin(), kinds.end());
  check_keys(node, "object", allowed);
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
  if (const OperatorName* combining = find_operator(entry.key)) {
    object.combination = combining->combination;
    read_children(entry, here, object);
    return object;
  }
  const PrimitiveDescription* description = find_primitive(entry.key);
  object.primitive = Primitive{description, description->read(entry.value, entry.key)};
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
  if (object.primitive) {
    const PrimitiveDescription& description = *object.primitive->description;
    append(node, std::string{description.name}, description.write(object.primitive->shape));
    return node;
  }
  std::vector<YamlNode> children;
  children.reserve(object.children.size());
  for (const Object& child : object.children) {
    children.push_back(write_object(child));
  }
  append(node, std::string{name_of(object.combination)}, yaml_sequence(std::move(children)));
  return node;
}

}  // namespace maquette::sim
