#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/fields/declaration.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The visitor of declared fields that writes them, every one with its value, as a mapping.
class FieldWriter {
 public:
  template <class Value, class Type>
  void field(const Declaration& declaration, const Value& value, const Type& type) {
    append(open_.back(), declaration.key, type.write(value));
  }

  template <class Value, class Type>
  void field(const Declaration& declaration, const std::optional<Value>& value, const Type& type) {
    if (value) {
      field(declaration, *value, type);
    }
  }

  template <class Body>
  void group(const Declaration& declaration, Body body) {
    open_.push_back(yaml_mapping());
    body();
    YamlNode mapping = std::move(open_.back());
    open_.pop_back();
    append(open_.back(), declaration.key, std::move(mapping));
  }

  template <class Body>
  void optional_group(const Declaration& declaration, const bool& present, Body body) {
    if (present) {
      group(declaration, body);
    }
  }

  /// The mapping; the writer is empty afterwards.
  YamlNode take() { return std::exchange(open_, {yaml_mapping()}).front(); }

 private:
  std::vector<YamlNode> open_{yaml_mapping()};
};

}  // namespace maquette::sim
