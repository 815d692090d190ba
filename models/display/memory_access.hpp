#pragma once

#include "models/bus/instant.hpp"

namespace maquette::models {

/// An access to the frame memory: wanted, and begun as soon as no slot of the video reader is in
/// its way.
struct MemoryAccess {
  Instant asked;
  Instant begun;
};

}  // namespace maquette::models
