#pragma once

#include "firmware/primitives/cylinder.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// Stands on z = 0 with its axis along z.
struct CylinderShape {
  using Kind = firmware::cylinder::Kind;

  double radius = 1;
  double height = 1;
};

[[nodiscard]] LocalFrame frame_of(const CylinderShape& shape);

}  // namespace maquette::sim
