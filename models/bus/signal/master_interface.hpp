#pragma once

#include <systemc>

#include "models/bus/bus_engine.hpp"
#include "models/bus/signal/arbitration_clocks.hpp"
#include "models/bus/signal/bus_cycle.hpp"
#include "models/bus/signal/bus_lines.hpp"
#include "models/bus/signal/grant_slot.hpp"
#include "models/bus/signal/line_monitor.hpp"
#include "models/bus/signal/settling.hpp"

namespace maquette::models {

/// What the interfaces of all boards have in common; it keeps the references.
struct Backpanel {
  BusParts parts;
  BusLines& lines;
  Settling& settling;
  LineMonitor& monitor;
  ArbitrationClocks clocks;
  bool is_ring;  ///< the chain of the grant
};

/// A board's interface to the lines, for one of the bus's masters: it requests the bus, takes the
/// grant, does the cycles of an access, and releases the bus or keeps it until the next one of a
/// block; BCLR makes it release the bus after an access, or at once between two.
class MasterInterface : public sc_core::sc_module {
 public:
  /// The slot is kept by reference.
  MasterInterface(const sc_core::sc_module_name& name, int master, const Backpanel& panel,
                  GrantSlot& slot);

  /// The master's burst has begun, whose first access it requests at `request`.
  void enter(Instant request);

 private:
  /// Who had the bus before, as BBSY told.
  enum class Predecessor { nobody, itself, another };

  void run();
  void watch_busy();
  void wait_for_request();
  BusGrant win();
  bool access(const BusGrant& granted);
  bool keep_until_request();
  void release();
  void know(Instant request);

  int master_;
  Backpanel panel_;
  GrantSlot& slot_;
  BusLine& request_line_;
  BusCycle cycle_;
  sc_core::sc_event posted_;
  Instant request_ = k_never;  // of the access that is next
  Predecessor predecessor_ = Predecessor::nobody;
  bool has_bus_ = false;
};

}  // namespace maquette::models
