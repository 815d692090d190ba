#pragma once

#include "models/bus/arbitration_priority.hpp"
#include "models/bus/duration.hpp"
#include "models/bus/transaction_level.hpp"

namespace maquette::models {

/// The VERSAbus backplane with its arbiter.
struct VersaBusParameters {
  int data_width_bits = 16;       ///< 16 or 32
  double clock_hz = 8e6;          ///< in which the clocks below are stated
  Clocks arbitration_clocks = 4;  ///< bus free and requested, to grant
  Clocks handover_clocks = 1;     ///< added when the master changes
  ArbitrationPolicy arbitration = k_priority;
  Duration timeout{64'000'000};  ///< of one access; 0 is off
  BusLevel level = k_transaction_level;
  Duration quantum{1'000'000'000};  ///< of run-ahead, at a level that has one
};

}  // namespace maquette::models
