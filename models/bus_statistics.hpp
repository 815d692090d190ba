#pragma once

#include <cstdint>
#include <vector>

#include "models/instant.hpp"

namespace maquette::models {

/// What one master did on the bus.
struct BusMasterStatistics {
  std::int64_t transfers = 0;  ///< accesses
  std::int64_t delayed = 0;    ///< accesses whose arbitration began after their request
  std::int64_t errors = 0;     ///< accesses that ended in a bus error
  Duration busy{};             ///< grants to releases
  Duration held{};             ///< gaps between accesses during which the bus was kept
  Duration arbitration{};      ///< from the bus free and requested to the grants
  Duration waited{};           ///< requests to grants, arbitration included
  Duration longest_wait{};
  Instant longest_wait_request{};
};

/// What happened on a bus, in integer ticks.
struct BusStatistics {
  std::vector<BusMasterStatistics> masters;

  /// waited_for[a][b]: how long a's requests stood while the bus was with b; for b = a, its own
  /// arbitration. A row sums to that master's `waited`.
  std::vector<std::vector<Duration>> waited_for;
};

/// All masters together; the longest wait is that of the earliest master that had it.
BusMasterStatistics total(const BusStatistics& statistics);

/// The number of the master that had the longest wait, or k_nobody on a bus without masters.
int longest_waiting_master(const BusStatistics& statistics);

}  // namespace maquette::models
