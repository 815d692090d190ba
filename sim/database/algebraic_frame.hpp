#pragma once

#include "sim/database/local_frame.hpp"

namespace maquette::sim {

/// An algebraic surface in the firmware's terms: its box is the cube from -1 to 1, its largest
/// coefficient of magnitude 1. The shape must be a checked one.
LocalFrame algebraic_frame(const AlgebraicShape& shape);

}  // namespace maquette::sim
