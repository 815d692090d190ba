#pragma once

#include <string>
#include <string_view>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Checks the name of a light, surface or object: letters (of any script), digits, `_` and `-`, at
/// most 200 of them, so that it can stand in a path of `--set`. Throws DescriptionError at `place`.
void check_name(const std::string& name, const YamlPlace& place, std::string_view what);

}  // namespace maquette::sim
