#pragma once

#include "firmware/primitives/cone.hpp"
#include "sim/primitives/axis.hpp"

namespace maquette::sim {

/// Stands on z = 0 with its axis along z.
struct ConeShape {
  using Kind = firmware::cone::Kind;

  double radius = 1;      ///< where the axis begins
  double top_radius = 0;  ///< where it ends; 0 is a pointed cone
  Axis axis;
};

/// A cone with equal radii is a cylinder.
[[nodiscard]] LocalFrame frame_of(const ConeShape& shape);

}  // namespace maquette::sim
