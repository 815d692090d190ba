#pragma once

#include <cstdint>
#include <vector>

#include "models/bus/arbitration.hpp"
#include "models/bus/bus_statistics.hpp"

namespace maquette::models {

/// One access, as an observer sees it. The strobes fall at the grant and rise at the end.
struct BusAccess {
  int master;
  std::uint64_t address;
  bool write;
  Instant request;
  Instant grant;
  Instant end;
  Instant decision{};         ///< its arbitration begins; the grant itself when it needed none
  Duration slave_time{};      ///< from the grant to the slave's acknowledge; the timeout's, if none
  bool answered = true;       ///< false: it ended in a bus error
  bool kept = false;          ///< until the decision, the master of the access before kept the bus
  bool test_and_set = false;  ///< it reads, and then writes in the same cycle
  std::uint32_t data =
      0;                ///< written, or read: first byte in the highest place, as the 68000 has it
  Duration handover{};  ///< of the time from decision to grant: another master had the bus before
};

/// Keeps the statistics of a bus while it decides one access after the other.
class BusAccount {
 public:
  void add_master();

  /// At an arbitration: `standing` are all requests up to its instant.
  void decide(Instant instant, const Contenders& standing);

  /// The bus is with `master` from one instant to another: `standing` are the requests up to its
  /// end. Those that come to be known later are told by `found_occupied`.
  void occupy(int master, Instant from, Instant to, const Contenders& standing);

  /// A request that came to be known while the bus was already given to `occupant` for this long.
  void found_occupied(int master, int occupant, Duration rest);

  void keep(int master, Duration gap) { at(master).held += gap; }
  void fail(int master) { ++at(master).errors; }

  /// A granted access; the arbitration that gave it the bus began at `decision`.
  void record(const BusAccess& access, Instant decision);

  /// After an access of its own, and with nobody else there, a master does so many that are alike,
  /// each so much after the one before. The first one waits no longer than the one before them.
  void repeat(const BusAccess& first, std::int64_t times, Duration period);

  /// Everything up to the last grant.
  [[nodiscard]] BusStatistics statistics() const;

 private:
  [[nodiscard]] BusMasterStatistics& at(int master) {
    return statistics_.masters[static_cast<std::size_t>(master)];
  }
  void record_longest_wait(const BusAccess& access);
  void assign_waits(const BusAccess& access);
  void pass_queue_time(Instant to);

  BusStatistics statistics_;
  std::vector<std::vector<Duration>> standing_;  // as waited_for, of the requests not yet granted

  // The queue is known up to an arbitration: later requests may still come to be known, and on a
  // decoupled bus earlier ones, which count from when they are.
  std::vector<unsigned char> queued_;  // by master: whether it is in the queue
  std::size_t queue_length_ = 0;
  Instant queue_known_to_{-1};
  Instant grant_ = k_never;  // at or after that arbitration, not yet taken off the queue
};

}  // namespace maquette::models
