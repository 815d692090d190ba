#pragma once

#include "sim/database/local_frame.hpp"

namespace maquette::sim {

/// A solid of revolution in the firmware's terms: the axis is z, the largest radius of a Bezier
/// point is 1, heights reach from -1 to 1; the generatrix has the solid on its left (paper, section
/// IV.2). The shape must be a checked one.
LocalFrame revolution_frame(const RevolutionShape& shape);

}  // namespace maquette::sim
