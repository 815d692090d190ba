#pragma once

#include <optional>

#include "models/bus/arbitration.hpp"
#include "models/bus/bus_grant.hpp"
#include "models/bus/instant.hpp"

namespace maquette::models {

/// Of a master with nobody else there.
struct BusSolitude {
  Instant until;         ///< excluded: the first request that is known of others
  Duration arbitration;  ///< from each of its requests to its grant
};

/// How the bus behaves: which of the requests is granted next, and when. An
/// ArbitratedEngine has one, which its BusLevel makes.
class BusArbiter {
 public:
  BusArbiter() = default;
  BusArbiter(const BusArbiter&) = delete;
  BusArbiter& operator=(const BusArbiter&) = delete;
  BusArbiter(BusArbiter&&) = delete;
  BusArbiter& operator=(BusArbiter&&) = delete;
  virtual ~BusArbiter() = default;

  /// A request is known, one per master at a time.
  virtual void enter(const Contender& contender) = 0;

  /// When the next grant is decided on, by the requests that are known; k_never without any.
  [[nodiscard]] virtual Instant next_decision() const = 0;

  /// Whether that decision must wait until no request up to its instant is unknown any more.
  [[nodiscard]] virtual bool heeds_unknown() const = 0;

  /// Decides at next_decision(), which is not k_never; the request stands no more.
  virtual BusGrant decide() = 0;

  /// The access of the last grant ends; its master keeps the bus until its next one if `keeps`.
  virtual void release(const BusGrant& granted, Instant end, bool keeps) = 0;

  /// How the master that has just released the bus, and has not entered its next request, would go
  /// on with nobody else there; nothing where the arbiter does not tell.
  [[nodiscard]] virtual std::optional<BusSolitude> solitude() const { return std::nullopt; }

  /// The master that has just released the bus goes on in its solitude: it has last been granted
  /// the bus by a decision of an instant, and released it at another, to keep it until its next
  /// access if `keeps`.
  virtual void go_on(Instant /*last_decision*/, Instant /*last_end*/, bool /*keeps*/) {}
};

}  // namespace maquette::models
