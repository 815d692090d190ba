#pragma once

#include "models/bus/arbitration.hpp"
#include "models/bus/bus_grant.hpp"
#include "models/bus/instant.hpp"

namespace maquette::models {

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
};

}  // namespace maquette::models
