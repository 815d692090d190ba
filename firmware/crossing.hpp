#pragma once

#include <cstdint>

#include "firmware/database.hpp"

namespace maquette::firmware {

/// A point where a ray passes from one medium into another. A ray's crossings are in order of
/// distance; before the first it is in the void.
template <class Real>
struct Crossing {
  Real distance;        ///< in lengths of the ray's direction
  NodeIndex leaf;       ///< whose surface it is
  std::uint8_t face;    ///< of the primitive
  bool outwards;        ///< the ray leaves the primitive here
  SurfaceIndex medium;  ///< behind the crossing: the surface of the body entered, or k_void
};

}  // namespace maquette::firmware
