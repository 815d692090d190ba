#pragma once

#include <string>
#include <string_view>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Checks the name of a light, surface or object: letters (of any script), digits, `_` and `-`, at
/// most 200 of them, so that it can stand in a path of `--set`. Throws DescriptionError at `place`.
void check_name(const std::string& name, const YamlPlace& place, std::string_view what);

/// What the name of a file or directory of results may be made of, for messages.
inline constexpr std::string_view k_file_name_letters =
    "letters, digits, spaces and . _ + - ( ) , = are allowed, up to 200, no . or - first";

/// Whether files or directories can be called so: it leads to no other place than the one meant.
[[nodiscard]] bool is_file_name(const std::string& name);

/// Checks that; throws DescriptionError at `place`.
void check_file_name(const std::string& name, const YamlPlace& place, std::string_view what);

}  // namespace maquette::sim
