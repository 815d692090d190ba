#pragma once

#include "sim/database/local_frame.hpp"

namespace maquette::sim {

/// A set of patches in the firmware's terms: Bezier points in [-1, 1], those of a solid with
/// normals outwards. The shape must be a checked one.
LocalFrame patches_frame(const PatchesShape& shape);

}  // namespace maquette::sim
