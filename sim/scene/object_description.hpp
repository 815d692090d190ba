#pragma once

#include <string_view>
#include <unordered_set>

#include "sim/scene/scene.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Operators in a row that an object tree may have.
inline constexpr int k_object_depth_limit = 200;

/// Reads an object with its children. A leaf's surface is its own or that of the nearest parent who
/// has one; every leaf must have one among `surfaces`. Throws DescriptionError, also when
/// placements along the tree together cannot be undone.
[[nodiscard]] Object read_object(const YamlNode& node,
                                 const std::unordered_set<std::string_view>& surfaces);

/// The object with its children, every value written.
[[nodiscard]] YamlNode write_object(const Object& object);

}  // namespace maquette::sim
