#pragma once

#include "models/bus/period.hpp"

namespace maquette::models {

/// How long an access of a bus master lasts, from its grant (address strobe) to the release of the
/// bus, by the slave's access time (data strobe to acknowledge).
struct AccessLaw {
  Period clock;           ///< of the master's processor
  Clocks access_clocks;   ///< of an access to a slave that costs no wait
  Duration access_slack;  ///< slave access time up to which there is none

  /// A processor that waits counts whole clocks: access_clocks, and one more for each clock begun
  /// beyond the slack (VM02 data sheet p. 2-57). It never ends an access before its acknowledge,
  /// which the slack alone would have it do when it is longer than the access_clocks: assumption
  /// for processors of more than some 71 MHz, of which the data sheet does not speak.
  [[nodiscard]] Duration duration(Duration slave_access_time) const {
    const Duration duration =
        clock.times(access_clocks + clock.count_to_cover(slave_access_time - access_slack));
    return duration >= slave_access_time ? duration
                                         : clock.times(clock.count_to_cover(slave_access_time));
  }
};

}  // namespace maquette::models
