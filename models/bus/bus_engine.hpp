#pragma once

#include "models/bus/bus_account.hpp"
#include "models/bus/bus_masters.hpp"
#include "models/bus/bus_slaves.hpp"

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

  /// Has a trace file of the kernel show the lines of the bus, at a level that has them.
  virtual void trace_lines(sc_core::sc_trace_file* /*file*/) const {}
};

}  // namespace maquette::models
