#pragma once

#include <string>

#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Where things are in the RAM of a machine's boards, a line each in the order of their addresses:
/// address and size in hexadecimal digits and the name of an area of the memory map, or indented of
/// a piece of the program, each with the bytes that it has for the scene.
std::string symbol_map(const PackedScene<float>& scene, const Machine& machine);

}  // namespace maquette::sim
