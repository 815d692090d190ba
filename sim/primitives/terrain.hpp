#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "firmware/primitives/terrain.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// A fractal terrain over a square centred on the origin, solid down to a level floor (paper,
/// section II.1; Kajiya 1983).
struct TerrainShape {
  using Kind = firmware::terrain::Kind;

  std::int32_t seed = 0;
  std::int32_t levels = 6;  ///< of subdivision: 2^levels cells along each edge
  double size = 1;          ///< edge of the square
  double displacement = 1;  ///< the greatest one of the first midpoints
  double roughness = 0.5;   ///< ratio of each level's greatest displacement to the one before
  std::vector<glm::dvec2> corners{{0, 0}, {0, 0}};  ///< heights, by rows: y low, then y high
  double depth = 1;                                 ///< of the floor below z = 0
};

/// A terrain in the firmware's terms: over the square from (0, 0) to (1, 1), with heights within
/// -1 and 1. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const TerrainShape& shape);

}  // namespace maquette::sim
