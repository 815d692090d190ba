#pragma once

#include <string>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Levels of nesting that a description may have.
inline constexpr int k_nesting_limit = 450;

/// Nodes that a description may have once its aliases are replaced by what they stand for.
inline constexpr std::size_t k_node_limit = 20'000'000;

/// Reads one YAML document. Aliases are replaced by copies of what they stand for; tags are not
/// used. Messages name `file`; the first line starts at
/// `first_column`.
/// Throws DescriptionError: broken syntax, double keys, keys that are no texts, more than one
/// document, nesting or size beyond the limits above.
[[nodiscard]] YamlNode parse_yaml(const std::string& text, const std::string& file,
                                  int first_column = 1);

/// Reads the document in `file`; throws DescriptionError, also when there is no such file.
[[nodiscard]] YamlNode load_yaml(const std::string& file);

}  // namespace maquette::sim
