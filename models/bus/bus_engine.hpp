#pragma once

#include "models/bus/bus_account.hpp"
#include "models/bus/bus_masters.hpp"
#include "models/bus/bus_slaves.hpp"
#include "models/bus/line_state.hpp"

namespace maquette::models {

/// What an engine works on; it keeps the references.
struct BusParts {
  BusMasters& masters;
  BusSlaves& slaves;
  BusAccount& account;
};

/// What carries the masters' accesses over the bus, so exactly as its BusLevel says, which makes
/// one. The bus itself does not know which one it has.
class BusEngine {
 public:
  BusEngine() = default;
  BusEngine(const BusEngine&) = delete;
  BusEngine& operator=(const BusEngine&) = delete;
  BusEngine(BusEngine&&) = delete;
  BusEngine& operator=(BusEngine&&) = delete;
  virtual ~BusEngine() = default;

  /// A master's burst has begun, whose first access it requests in an instant that is not past.
  virtual void enter(int master, Instant request) = 0;

  /// A master has posted a burst or retires: there may be more to decide on.
  virtual void advance() = 0;

  /// Every line of the bus is shown to an observer, at a level that has lines: as it is when the
  /// elaboration ends, and then at every change. To be called before.
  virtual void observe_lines(const LineObserver& /*observer*/) {}
};

}  // namespace maquette::models
