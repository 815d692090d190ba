#pragma once

#include "models/bus/duration.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// The EXORmacs host that writes code and database into the boards' RAM before the frame.
struct HostParameters {
  BusMasterPlace place{4, 0};
  double clock_hz = 8e6;
  Clocks word_clocks = 22;  ///< of its copying loop, per 16-bit word, besides the bus access
  bool loads_code = true;   ///< besides the database
};

}  // namespace maquette::models
