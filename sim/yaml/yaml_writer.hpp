#pragma once

#include <string>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The document as text that parse_yaml reads back to the same tree. Lists of plain values stand on
/// one line, everything else is indented.
[[nodiscard]] std::string write_yaml(const YamlNode& root);

/// The node on one line: `{a: 1, b: [2, 3]}`.
[[nodiscard]] std::string write_flow(const YamlNode& node);

}  // namespace maquette::sim
