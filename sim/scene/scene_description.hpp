#pragma once

#include <string_view>
#include <vector>

#include "sim/fields/parameter_table.hpp"
#include "sim/scene/scene.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Reads and checks a scene; its key `machine` is left to others. Throws DescriptionError.
[[nodiscard]] Scene read_scene(const YamlNode& root);

/// The whole scene with every value.
[[nodiscard]] YamlNode write_scene(Scene scene);

/// Every parameter of the scene for people, the object tree left out.
[[nodiscard]] std::vector<ParameterRow> list_parameters(const Scene& scene);

/// The keys at the top of a scene description.
[[nodiscard]] std::vector<std::string_view> scene_keys();

}  // namespace maquette::sim
