#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The visitor of declared fields that reads them from a mapping. What the mapping leaves out keeps
/// its value. Throws DescriptionError for keys that are not declared, required ones that are
/// missing, and values that their type refuses.
class FieldReader {
 public:
  /// `what` names the mapping in messages, e.g. "sphere"; nothing written is an empty mapping.
  FieldReader(const YamlNode& mapping, std::string_view what);

  template <class Value, class Type>
  void field(const Declaration& declaration, Value& value, const Type& type) {
    if (const YamlNode* node = take(declaration)) {
      assign(value, type.read(*node, declaration.key));
    }
  }

  template <class Value, class Type>
  void field(const Declaration& declaration, std::optional<Value>& value, const Type& type) {
    if (const YamlNode* node = take(declaration)) {
      assign(value.emplace(), type.read(*node, declaration.key));
    }
  }

  template <class Body>
  void group(const Declaration& declaration, Body body) {
    if (const YamlNode* node = take(declaration)) {
      enter(*node, declaration.key);
      body();
      leave();
    }
  }

  /// A group that is there or not, which `present` tells.
  template <class Body>
  void optional_group(const Declaration& declaration, bool& present, Body body) {
    present = present || current().mapping->find(declaration.key) != nullptr;
    group(declaration, body);
  }

  /// Lets a key stand that others read.
  void allow(std::string_view key) { current().allowed.push_back(key); }

  /// To be called after the last field: checks that nothing else is written.
  void finish() { leave(); }

 private:
  struct Frame {
    const YamlNode* mapping;
    std::string_view what;
    std::vector<std::string_view> allowed;
    std::vector<std::string_view> missing;
  };

  Frame& current() { return frames_.back(); }
  const YamlNode* take(const Declaration& declaration);
  void enter(const YamlNode& mapping, std::string_view what);
  void leave();

  std::vector<Frame> frames_;
};

/// Throws the error about the first of `node`'s keys that is not among `allowed`.
void check_keys(const YamlNode& node, std::string_view what,
                const std::vector<std::string_view>& allowed);

/// Throws DescriptionError unless `node` is a mapping or nothing.
void check_mapping(const YamlNode& node, std::string_view what);

}  // namespace maquette::sim
