#pragma once

#include <string>

#include "sim/yaml/input_file.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Levels of nesting that a description may have.
inline constexpr int k_nesting_limit = 450;

/// Memory that the values of a description may take once its aliases are replaced by what they
/// stand for; with what the parser needs the program stays below a GiB.
inline constexpr std::size_t k_tree_limit_bytes = 544U << 20U;

/// Reads one YAML document. Aliases are replaced by copies of what they stand for; tags are not
/// used. Messages name `file`; the first line starts at
/// `first_column`.
/// Throws DescriptionError: broken syntax, double keys, keys that are no texts, more than one
/// document, nesting or size beyond the limits above.
[[nodiscard]] YamlNode parse_yaml(const std::string& text, const std::string& file,
                                  int first_column = 1);

/// The same for a file that was read.
[[nodiscard]] YamlNode parse_yaml(const InputFile& input);

/// Reads the document in `file`; throws DescriptionError, also when there is no such file.
[[nodiscard]] YamlNode load_yaml(const std::string& file);

}  // namespace maquette::sim
