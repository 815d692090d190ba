#pragma once

#include "sim/machine/machine.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Checks what no single value of a machine shows: places on the bus, the picture within the video
/// standard, areas within the RAM, times below the bus timeout. Throws DescriptionError at the
/// value of `root` (what the machine was read from) that is to blame.
void check_machine(const Machine& machine, const YamlNode& root);

}  // namespace maquette::sim
