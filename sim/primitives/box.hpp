#pragma once

#include "firmware/primitives/box.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// Centred on the origin.
struct BoxShape {
  using Kind = firmware::box::Kind;

  Vector3 size{1, 1, 1};  ///< edge lengths
};

[[nodiscard]] LocalFrame frame_of(const BoxShape& shape);

}  // namespace maquette::sim
