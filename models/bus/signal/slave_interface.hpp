#pragma once

#include <systemc>
#include <tlm>
#include <vector>

#include "models/bus/bus_slaves.hpp"
#include "models/bus/signal/bus_lines.hpp"

namespace maquette::models {

/// A slave's interface to the lines: at a strobe for one of its addresses it has the slave's model
/// do the transfer, and pulls DTACK when that has taken its access time; with an error BERR as
/// well. A transfer that the bus timer ends before is not answered.
class SlaveInterface : public sc_core::sc_module {
 public:
  /// Slaves and lines are kept by reference.
  SlaveInterface(const sc_core::sc_module_name& name, int slave, unsigned word_bytes,
                 BusSlaves& slaves, BusLines& lines);

 private:
  void run();
  void wait_for_strobe() const;
  Duration transfer();
  [[nodiscard]] bool is_strobed_after(Duration access_time) const;
  void answer();

  int slave_;
  BusSlaves& slaves_;
  BusLines& lines_;
  std::vector<unsigned char> bytes_;
  BusStrobe strobe_;  // before the payload, which frees its extensions
  tlm::tlm_generic_payload payload_;
};

}  // namespace maquette::models
