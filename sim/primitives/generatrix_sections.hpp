#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim/primitives/revolution.hpp"

namespace maquette::sim {

/// The Bezier points of the cubic sections that the points of a generatrix make: three for each
/// section and the last. All kinds commute with stretching and moving the points.
[[nodiscard]] std::vector<glm::dvec2> sections_of(const std::vector<glm::dvec2>& points,
                                                  GeneratrixKind kind, bool closed);

}  // namespace maquette::sim
