#pragma once

#include "models/bus/duration.hpp"

namespace maquette::models {

/// Which master the arbiter of the bus prefers among those of the same instant.
enum class ArbitrationPolicy { priority, round_robin };

/// How exactly the bus is simulated: every request arbitrated at its instant; masters that run
/// ahead of one another for a quantum; or no contention at all.
enum class BusLevel { transaction, decoupled, ideal };

/// The VERSAbus backplane with its arbiter.
struct VersaBusParameters {
  int data_width_bits = 16;       ///< 16 or 32
  double clock_hz = 8e6;          ///< in which the clocks below are stated
  Clocks arbitration_clocks = 4;  ///< bus free and requested, to grant
  Clocks handover_clocks = 1;     ///< added when the master changes
  ArbitrationPolicy arbitration = ArbitrationPolicy::priority;
  Duration timeout{64'000'000};  ///< of one access; 0 is off
  BusLevel level = BusLevel::transaction;
  Duration quantum{1'000'000'000};  ///< of run-ahead, when decoupled
};

/// Where a master sits on the bus.
struct BusMasterPlace {
  int level = 0;     ///< request level 0..4; 4 is the highest
  int position = 0;  ///< in the daisy chain of its level; 0 is nearest to the arbiter
};

}  // namespace maquette::models
