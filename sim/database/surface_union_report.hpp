#pragma once

#include <string>

#include "sim/database/packed_scene.hpp"

namespace maquette::sim {

/// The trees in which boards unite the sections of surfaces of revolution (the paper's operator
/// +S), as text: of each node its parent, its sons, its sections and its extent in the local frame.
/// Empty when there are none.
[[nodiscard]] std::string surface_union_report(const PackedScene<float>& scene);

}  // namespace maquette::sim
