#pragma once

#include <cstdint>
#include <vector>

#include "models/unit/unit_kind.hpp"
#include "sim/database/packed_scene.hpp"

namespace maquette::sim {

/// What a function unit of a kind is loaded with of a scene, and what that takes of its RAM.
struct UnitDatabase {
  std::vector<unsigned char> loaded;  ///< the arrays that it reads, as a board's RAM has them
  std::int64_t used_bytes = 0;        ///< with what preprocessing makes of them
};

/// Leaves and their parameters for intersections; leaves, composites and extents for extents;
/// composites for combinations; leaves, parameters, surfaces, lights and textures for photometry;
/// all for secondary rays. Assumption: a unit prepares its data as boards do, in their
/// preprocessing, and has its program in a ROM of its own.
[[nodiscard]] UnitDatabase unit_database(models::UnitKind kind, const PackedScene<float>& scene,
                                         firmware::NumberFormat numbers);

}  // namespace maquette::sim
