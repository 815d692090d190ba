#pragma once

#include "firmware/primitives/cone.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// Stands on z = 0 with its axis along z.
struct ConeShape {
  using Kind = firmware::cone::Kind;

  double radius = 1;      ///< at z = 0
  double top_radius = 0;  ///< at z = height; 0 is a pointed cone
  double height = 1;
};

/// A cone with equal radii is a cylinder.
[[nodiscard]] LocalFrame frame_of(const ConeShape& shape);

}  // namespace maquette::sim
