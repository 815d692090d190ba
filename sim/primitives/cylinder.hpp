#pragma once

#include "firmware/primitives/cylinder.hpp"
#include "sim/primitives/axis.hpp"

namespace maquette::sim {

/// Stands on z = 0 with its axis along z.
struct CylinderShape {
  using Kind = firmware::cylinder::Kind;

  double radius = 1;
  Axis axis;
};

[[nodiscard]] LocalFrame frame_of(const CylinderShape& shape);

}  // namespace maquette::sim
