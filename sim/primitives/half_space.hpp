#pragma once

#include "firmware/primitives/half_space.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// All below z = 0.
struct HalfSpaceShape {
  using Kind = firmware::half_space::Kind;
};

[[nodiscard]] LocalFrame frame_of(const HalfSpaceShape& shape);

}  // namespace maquette::sim
