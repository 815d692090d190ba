#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <tlm>
#include <vector>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// Extension of a master's payload, which is a burst of accesses of the bus's data width. A payload
/// without it is a burst without gaps, released after each access. It belongs to the master.
struct BusTransaction : tlm::tlm_extension<BusTransaction> {
  // What the master asks.
  Duration gap{};                  ///< from the end of one access to the request of the next
  std::int64_t longer_gaps = 0;    ///< so many of the first gaps last a tick longer
  std::int64_t item_accesses = 1;  ///< only items of so many accesses have gaps between them
  bool block = false;              ///< the bus is kept from the first access to the last
  bool runs_ahead = false;  ///< promise: the master posts its next transaction, or retires, or says
                            ///< what it does, in the kernel instant in which this one ends (the bus
                            ///< saves a wake-up)
  bool test_and_set = false;  ///< of a burst that reads: each access is a read-modify-write cycle,
                              ///< which sets the top bit of the first byte under one grant
  Duration modify{};          ///< between its read and its write
  std::vector<std::uint64_t> addresses;  ///< of the accesses; empty when they are consecutive

  /// Called at the end of a burst that was answered, in the bus's own time: a master that has its
  /// next burst ready puts it into the same payload and returns the time from `end` to its request;
  /// else it returns nothing and is woken. Saves the kernel a wake-up per burst.
  std::function<std::optional<Duration>(Instant end)> follow_up;

  // What the bus answers.
  std::int64_t accesses = 0;
  Duration waited{};                 ///< requests to grants
  Duration transferred{};            ///< grants to releases
  Duration longest_wait{};           ///< of one access
  Instant longest_wait_request{};    ///< when that access was requested
  std::uint64_t failed_address = 0;  ///< of the access that ended in a bus error, if one did

  /// From the access that has just ended to the next one.
  [[nodiscard]] Duration next_gap() const {
    if (item_accesses > 1 && accesses % item_accesses != 0) {
      return Duration::zero();
    }
    return accesses / item_accesses <= longer_gaps ? gap + k_tick : gap;
  }

  /// All gaps between the accesses so far, which are whole items.
  [[nodiscard]] Duration gaps() const {
    const std::int64_t count = accesses / item_accesses - 1;
    return gap * count + k_tick * std::min(count, longer_gaps);
  }

  [[nodiscard]] tlm_extension_base* clone() const override { return new BusTransaction(*this); }
  void copy_from(const tlm_extension_base& other) override {
    *this = static_cast<const BusTransaction&>(other);
  }
  void free() override {}  // not the payload's: the master keeps it
};

/// Extension of the payload of one access, as a slave sees it: the exact instant of its data
/// strobe. The kernel may be a tick past it, which the unsigned TLM delay cannot say.
struct BusStrobe : tlm::tlm_extension<BusStrobe> {
  Instant instant{};

  [[nodiscard]] tlm_extension_base* clone() const override { return new BusStrobe(*this); }
  void copy_from(const tlm_extension_base& other) override {
    *this = static_cast<const BusStrobe&>(other);
  }
  void free() override {}  // not the payload's: the bus keeps it
};

}  // namespace maquette::models
