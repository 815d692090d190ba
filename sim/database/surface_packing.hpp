#pragma once

#include "firmware/database.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A surface in the firmware's form, in double precision.
firmware::Surface<double> packed_surface(const Surface& surface);

}  // namespace maquette::sim
