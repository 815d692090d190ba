#pragma once

#include <string>
#include <vector>

#include "sim/yaml/yaml_node.hpp"

/// What the harnesses of descriptions share.
namespace maquette::fuzz {

/// Reads a document and holds the law of writing: what was written reads back to what writes the
/// same bytes. Throws DescriptionError for what is no document.
[[nodiscard]] sim::YamlNode read_tree(const std::string& input);

/// The texts of the files below a folder of the project, in the order of their names; those that
/// are longer than `most_bytes` left out.
[[nodiscard]] std::vector<std::string> texts_below(const std::string& folder,
                                                   std::size_t most_bytes);

}  // namespace maquette::fuzz
