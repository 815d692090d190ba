#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "models/bus/access_law.hpp"
#include "models/bus/burst_progress.hpp"
#include "models/bus/bus_account.hpp"
#include "models/bus/bus_grant.hpp"
#include "models/bus/bus_lookahead.hpp"
#include "models/bus/bus_slaves.hpp"

namespace maquette::models {

/// What the bus knows of one of its masters.
struct BusMaster {
  std::string name;
  BusMasterPlace place;
  AccessLaw access;
};

/// The masters of a bus, numbered from 0, and how far each has come with its burst.
class BusMasters {
 public:
  /// The account is kept by reference.
  BusMasters(unsigned word_bytes, BusAccount& account)
      : word_bytes_(word_bytes), account_(account) {}

  /// A new master's number. Throws std::invalid_argument when its place is taken or outside the
  /// five levels, or when an access takes no clock.
  int add(const BusMaster& master);

  /// Shows every access from now on.
  void observe(std::function<void(const BusAccess&)> observer) { observer_ = std::move(observer); }

  /// A master begins a burst.
  void post(int master, tlm::tlm_generic_payload& burst, Instant request);

  /// Waits for the end of its burst, in the master's process.
  void await(int master) const { sc_core::wait(at(master).completed); }

  /// The access that is next, as it went when it was granted so.
  [[nodiscard]] BusAccess access_of(const BusGrant& granted, const AccessResult& result) const;

  /// Whether accesses are shown.
  [[nodiscard]] bool is_observed() const { return observer_ != nullptr; }

  /// Whether the master of an access keeps the bus until its next one.
  [[nodiscard]] bool keeps_bus(const BusAccess& access) const;

  /// An access has ended: accounts for it and shows it. Returns when its master requests its next
  /// one; nothing when it has none, because its burst has ended and none follows up.
  std::optional<Instant> finish(const BusAccess& access, tlm::tlm_response_status status);

  /// The next accesses of a burst have ended, so many of them, as BusAccount::repeat has them.
  /// Returns as `finish`.
  std::optional<Instant> repeat(const BusAccess& first, std::int64_t times, Duration period);

  [[nodiscard]] int count() const { return static_cast<int>(masters_.size()); }
  [[nodiscard]] const BusMaster& operator[](int master) const { return at(master).description; }
  [[nodiscard]] BurstProgress& burst(int master) const { return at(master).burst; }
  [[nodiscard]] BusLookahead& lookahead() { return lookahead_; }
  [[nodiscard]] const BusLookahead& lookahead() const { return lookahead_; }

 private:
  struct Master {
    Master(BusMaster what, unsigned word_bytes) : description(std::move(what)), burst(word_bytes) {}

    BusMaster description;
    BurstProgress burst;
    sc_core::sc_event completed;
  };

  void check_place(const BusMaster& master) const;
  std::optional<Instant> requested(int master, Instant request);
  std::optional<Instant> complete(int id, Instant end, tlm::tlm_response_status status);
  [[nodiscard]] Master& at(int master) const { return *masters_[static_cast<std::size_t>(master)]; }

  unsigned word_bytes_;
  BusAccount& account_;
  std::vector<std::unique_ptr<Master>> masters_;
  BusLookahead lookahead_;
  std::function<void(const BusAccess&)> observer_;
};

}  // namespace maquette::models
