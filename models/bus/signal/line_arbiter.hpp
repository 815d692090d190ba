#pragma once

#include <systemc>

#include "models/bus/arbitration.hpp"
#include "models/bus/signal/bus_lines.hpp"
#include "models/bus/signal/settling.hpp"

namespace maquette::models {

/// The arbiter of the system controller: when the bus is free and requested, it grants it to the
/// highest level that requests (or to the ring of all), and takes the grant back when a board has
/// pulled BBSY. Under a policy that clears the bus, it pulls BCLR while a level above that of the
/// board that has the bus requests.
class LineArbiter : public sc_core::sc_module {
 public:
  /// Lines and settling are kept by reference.
  LineArbiter(const sc_core::sc_module_name& name, const ArbitrationPolicy& policy, BusLines& lines,
              Settling& settling);

 private:
  void run();
  void clear();
  [[nodiscard]] int highest_request() const;
  void wait_for_request() const;

  bool is_ring_;
  BusLines& lines_;
  Settling& settling_;
  sc_core::sc_event_or_list any_request_;
  sc_core::sc_signal<int> granted_level_;  // last
};

}  // namespace maquette::models
