#pragma once

#include <systemc>

#include "models/bus/address_map.hpp"
#include "models/bus/duration.hpp"
#include "models/bus/signal/bus_lines.hpp"

namespace maquette::models {

/// The bus timer of the system controller (VM02 data sheet p. 2-54): it pulls BERR when no slave
/// has answered a strobe by the timeout; one that answers in that very instant is in time. While
/// it is off it answers, at once and with both DTACK and BERR, where no slave is.
class BusTimer : public sc_core::sc_module {
 public:
  /// A `timeout` of zero is off. Lines and map are kept by reference.
  BusTimer(const sc_core::sc_module_name& name, Duration timeout, const AddressMap& map,
           BusLines& lines);

 private:
  void run();
  void time();
  void answer_vacancy();

  Duration timeout_;
  const AddressMap& map_;
  BusLines& lines_;
};

}  // namespace maquette::models
