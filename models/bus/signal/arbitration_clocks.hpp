#pragma once

#include "models/bus/period.hpp"

namespace maquette::models {

/// What a board that is granted the bus lets pass before its address strobe falls.
struct ArbitrationClocks {
  Period clock;
  Clocks arbitration;  ///< of the arbiter, the chain and BBSY
  Clocks handover;     ///< more, when another board had the bus before

  [[nodiscard]] Duration duration(bool hands_over) const {
    return clock.times(arbitration + (hands_over ? handover : 0));
  }
};

}  // namespace maquette::models
