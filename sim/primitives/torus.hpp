#pragma once

#include "firmware/primitives/torus.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// A ring around z, its middle in the plane z = 0.
struct TorusShape {
  using Kind = firmware::torus::Kind;

  double major_radius = 1;    ///< from the axis to the middle of the tube
  double minor_radius = 0.5;  ///< of the tube
};

/// The outer radius is 1 in the local frame. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const TorusShape& shape);

}  // namespace maquette::sim
