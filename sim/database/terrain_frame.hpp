#pragma once

#include "sim/database/local_frame.hpp"

namespace maquette::sim {

/// A terrain in the firmware's terms: over the square from (0, 0) to (1, 1), with heights within
/// -1 and 1. The shape must be a checked one.
LocalFrame terrain_frame(const TerrainShape& shape);

}  // namespace maquette::sim
