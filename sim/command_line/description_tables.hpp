#pragma once

#include <string>

#include "sim/report/table.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The parameters of a scene and its machine, with those of the scene's objects as its file has
/// them.
[[nodiscard]] Table parameter_table(const Description& description);

/// The parameters of a machine.
[[nodiscard]] Table parameter_table(const Machine& machine);

/// The object tree of a scene's file as paths for --set and --vary, with their values.
[[nodiscard]] Table object_table(const YamlNode& scene);

/// The keys of stats.json that have one value for a run, as sweeps and plots take them.
[[nodiscard]] Table statistics_table();

/// The maps that there are.
[[nodiscard]] Table maps_table();

/// The keys of a part of descriptions. Throws as key_help.
[[nodiscard]] Table keys_table(const std::string& part);

}  // namespace maquette::sim
