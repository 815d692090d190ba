#pragma once

#include <string>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// Lets the lines settle before they are looked at, within one instant: what boards put on them in
/// an instant counts in that instant, in whichever order the kernel has their processes run. So
/// a request of the very instant in which the bus is free takes part in the arbitration.
///
/// The kernel does not tell when an instant is over for good; so an instant settles for a number
/// of delta cycles, and a request after them is misuse.
class Settling {
 public:
  /// Far more than a board needs from the end of its access to its next request, which is four.
  static constexpr int k_delta_cycles = 16;

  /// Waits, in a process, until the present instant has settled.
  void wait();

  /// Reports misuse of a request that comes into an instant that had settled already.
  void check(Instant request, const std::string& master) const;

 private:
  Instant settled_{-1};
};

}  // namespace maquette::models
