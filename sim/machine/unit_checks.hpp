#pragma once

#include "sim/machine/machine.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Throws DescriptionError, with its place, for function units with which there is no machine, or
/// one that could deadlock.
void check_units(const Machine& machine, const YamlNode& root);

}  // namespace maquette::sim
