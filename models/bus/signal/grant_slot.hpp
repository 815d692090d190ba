#pragma once

#include <systemc>

#include "models/bus/signal/bus_lines.hpp"

namespace maquette::models {

/// A board's place in the daisy chain of the grant: it takes a grant that comes from its left if it
/// wants the bus then, else it passes it on to its right until it is taken back. In a ring, the
/// slot of the board that had the bus last is where the arbiter's grant begins its way, so that
/// this board comes last.
class GrantSlot : public sc_core::sc_module {
 public:
  /// The lines are kept by reference; `arbiter` is the grant as the arbiter drives it.
  GrantSlot(const sc_core::sc_module_name& name, const BusLine& arbiter, const BusLine& left,
            BusLine& right);

  void want(bool wants) { wants_.write(wants); }
  void wait_for_grant() const;
  void start_ring(bool starts) { starts_.write(starts); }

 private:
  void pass();

  const BusLine& arbiter_;
  const BusLine& left_;
  BusLine& right_;
  sc_core::sc_signal<bool> wants_;
  sc_core::sc_signal<bool> has_grant_;
  sc_core::sc_signal<bool, sc_core::SC_MANY_WRITERS> starts_;  // of the board's two processes
  bool had_come_ = false;                                      // the grant, from the left
  bool takes_ = false;
};

}  // namespace maquette::models
