#pragma once

#include <string>
#include <vector>

#include "firmware/database.hpp"
#include "sim/scene/scene.hpp"
#include "sim/stability/random_cases.hpp"
#include "sim/stability/shipped_scenes.hpp"

namespace maquette::sim {

/// All solids of one primitive that scenes show. Each is placed so that it fits the cube from -1 to
/// 1, as far as it has bounds; its surface is the first trial surface.
struct SolidFamily {
  std::string name;
  firmware::PrimitiveKind kind;
  bool is_bounded;
  std::vector<Object> solids;
};

/// A family for each primitive that occurs, in the order of the firmware's table.
[[nodiscard]] std::vector<SolidFamily> solid_families(const std::vector<ShippedScene>& scenes);

/// One of a family at random, in a frame.
[[nodiscard]] Object random_solid(trial::Random& random, const SolidFamily& family,
                                  const Placement& placement);

}  // namespace maquette::sim
