#pragma once

#include <cstdint>
#include <vector>

#include "models/bus/arbitration.hpp"
#include "models/bus/instant.hpp"
#include "models/bus/wait_histogram.hpp"

namespace maquette::models {

/// What one master did on the bus.
struct BusMasterStatistics {
  std::int64_t transfers = 0;  ///< accesses
  std::int64_t delayed = 0;    ///< accesses whose arbitration began after their request
  std::int64_t errors = 0;     ///< accesses that ended in a bus error
  Duration busy{};             ///< grants to releases
  Duration held{};             ///< gaps between accesses during which the bus was kept
  Duration arbitration{};      ///< from the bus free and requested to the grants
  Duration handover{};         ///< of `arbitration`: since another master had the bus before
  Duration waited{};           ///< requests to grants, arbitration included
  Duration longest_wait{};     ///< the earliest of the longest
  Instant longest_wait_request{};
  int longest_wait_behind = k_nobody;  ///< the master that had the bus for most of that wait
  WaitHistogram waits;                 ///< of all accesses
};

/// What happened on a bus, in integer ticks.
struct BusStatistics {
  std::vector<BusMasterStatistics> masters;

  /// waited_for[a][b]: how long a's requests stood while the bus was with b, until their grants;
  /// for b = a, its own arbitration. A row sums to that master's `waited`.
  std::vector<std::vector<Duration>> waited_for;

  /// queue_times[n]: how long exactly n + 1 requests stood, each from its instant to its grant.
  std::vector<Duration> queue_times;
};

/// All masters together; the longest wait is that of the earliest master that had it. Throws as
/// checked_sum.
BusMasterStatistics total(const BusStatistics& statistics);

/// The backplanes of a machine as one bus: its boards are masters 0 to boards - 1, board b being
/// the b / n th master of the b mod n th of n backplanes; the last master of each is the host, all
/// of which are summed up as master `boards`. Masters of different backplanes never wait for one
/// another; lengths of queues are those of any backplane. Throws as checked_sum.
BusStatistics combined(const std::vector<BusStatistics>& backplanes, std::size_t boards);

/// The number of the master that had the longest wait, or k_nobody on a bus without masters.
int longest_waiting_master(const BusStatistics& statistics);

}  // namespace maquette::models
