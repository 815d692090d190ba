#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/source_position.hpp"

namespace maquette::sim {

/// Where a node stands; the file's name is shared by all nodes of the file.
struct YamlPlace {
  std::shared_ptr<const std::string> file;
  int line = 1;
  int column = 1;

  [[nodiscard]] SourcePosition position() const;
};

enum class YamlKind { null, scalar, sequence, mapping };

struct YamlEntry;

/// A value of a description with the place where it was written. The order of mappings is kept and
/// their keys are unique.
struct YamlNode {
  YamlKind kind = YamlKind::null;
  YamlPlace place;
  std::string text;                ///< of a scalar, without quotes
  std::vector<YamlNode> items;     ///< of a sequence
  std::vector<YamlEntry> entries;  ///< of a mapping

  /// The value under `key` of a mapping; null pointer when absent or when this is no mapping.
  [[nodiscard]] const YamlNode* find(std::string_view key) const;
  [[nodiscard]] YamlNode* find(std::string_view key);

  /// "a text", "a list", ... for messages.
  [[nodiscard]] std::string kind_name() const;
};

struct YamlEntry {
  std::string key;
  YamlPlace place;  ///< of the key
  YamlNode value;
};

/// Nodes made by the program rather than read from a file.
[[nodiscard]] YamlNode yaml_scalar(std::string text);
[[nodiscard]] YamlNode yaml_sequence(std::vector<YamlNode> items);
[[nodiscard]] YamlNode yaml_mapping();

/// Appends `key: value` to a mapping.
void append(YamlNode& mapping, std::string_view key, YamlNode value);

/// The deepest node that exists on a path such as "board.call_overhead.clocks", for messages.
[[nodiscard]] const YamlNode& nearest_node(const YamlNode& root, std::string_view path);

}  // namespace maquette::sim
