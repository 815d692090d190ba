#include "sim/fields/field_reader.hpp"

#include <algorithm>

#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {

void check_mapping(const YamlNode& node, std::string_view what) {
  if (node.kind != YamlKind::mapping && node.kind != YamlKind::null) {
    throw DescriptionError(node.place.position(), std::string{what} + ": " + node.kind_name() +
                                                      " stands here; a mapping is allowed");
  }
}

void check_keys(const YamlNode& node, std::string_view what,
                const std::vector<std::string_view>& allowed) {
  for (const YamlEntry& entry : node.entries) {
    if (std::find(allowed.begin(), allowed.end(), entry.key) == allowed.end()) {
      throw DescriptionError(entry.place.position(), std::string{what} + ": unknown key `" +
                                                         entry.key + "`; " +
                                                         allowed_names(entry.key, allowed));
    }
  }
}

FieldReader::FieldReader(const YamlNode& mapping, std::string_view what) { enter(mapping, what); }

const YamlNode* FieldReader::take(const Declaration& declaration) {
  Frame& frame = current();
  frame.allowed.push_back(declaration.key);
  const YamlNode* node = frame.mapping->find(declaration.key);
  if (node == nullptr && declaration.required) {
    frame.missing.push_back(declaration.key);
  }
  return node;
}

void FieldReader::enter(const YamlNode& mapping, std::string_view what) {
  check_mapping(mapping, what);
  frames_.push_back({&mapping, what, {}, {}});
}

void FieldReader::leave() {
  const Frame& frame = current();
  check_keys(*frame.mapping, frame.what, frame.allowed);
  if (!frame.missing.empty()) {
    throw DescriptionError(
        frame.mapping->place.position(),
        std::string{frame.what} + ": `" + std::string{frame.missing.front()} + "` is missing");
  }
  frames_.pop_back();
}

}  // namespace maquette::sim
