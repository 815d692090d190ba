#pragma once

#include <vector>

#include "sim/primitives/patch_nets.hpp"

namespace maquette::sim {

/// Numbers of the patches in an order in which those of every node of a balanced binary tree lie
/// together: halved along the longest edge of their box, again and again.
[[nodiscard]] std::vector<std::size_t> patch_order(const std::vector<PatchNet>& nets);

}  // namespace maquette::sim
