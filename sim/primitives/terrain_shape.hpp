#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace maquette::sim {

/// A fractal terrain over a square centred on the origin, solid down to a level floor (paper,
/// section II.1; Kajiya 1983).
struct TerrainShape {
  std::int32_t seed = 0;
  std::int32_t levels = 6;  ///< of subdivision: 2^levels cells along each edge
  double size = 1;          ///< edge of the square
  double displacement = 1;  ///< the greatest one of the first midpoints
  double roughness = 0.5;   ///< ratio of each level's greatest displacement to the one before
  std::vector<glm::dvec2> corners{{0, 0}, {0, 0}};  ///< heights, by rows: y low, then y high
  double depth = 1;                                 ///< of the floor below z = 0
};

}  // namespace maquette::sim
