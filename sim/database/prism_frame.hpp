#pragma once

#include "sim/database/local_frame.hpp"

namespace maquette::sim {

/// A prism in the firmware's terms: the rectangle around its outline reaches from -1 to 1, as do
/// its heights. The shape must be a checked one.
LocalFrame prism_frame(const PrismShape& shape);

}  // namespace maquette::sim
