#pragma once

#include "sim/primitives/local_frame.hpp"
#include "sim/primitives/revolution.hpp"

namespace maquette::sim {

/// What is swept by a generatrix in the firmware's terms: the axis is z, the largest radius of a
/// Bezier point is 1, heights reach from -1 to 1 (paper, section IV.2); of a displaced one between
/// half of that and all, so that what is not displaced stays. The kind is one whose parameters are
/// those of a generatrix. The shape must be a checked one.
[[nodiscard]] LocalFrame generatrix_frame(const RevolutionShape& shape,
                                          firmware::PrimitiveKind kind);

}  // namespace maquette::sim
