#pragma once

#include "models/bus/duration.hpp"

namespace maquette::models {

/// A memory board on the bus, of machines whose boards share something.
struct SharedMemoryParameters {
  Duration access_time{250'000};  ///< data strobe to acknowledge
};

}  // namespace maquette::models
