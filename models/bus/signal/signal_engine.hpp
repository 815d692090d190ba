#pragma once

#include <memory>
#include <optional>
#include <systemc>
#include <vector>

#include "models/bus/bus_engine.hpp"
#include "models/bus/signal/bus_lines.hpp"
#include "models/bus/signal/bus_timer.hpp"
#include "models/bus/signal/grant_slot.hpp"
#include "models/bus/signal/line_arbiter.hpp"
#include "models/bus/signal/line_monitor.hpp"
#include "models/bus/signal/line_watch.hpp"
#include "models/bus/signal/master_interface.hpp"
#include "models/bus/signal/settling.hpp"
#include "models/bus/signal/slave_interface.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// The bus as its lines, and the processes that drive them: arbiter and timer of the system
/// controller, a daisy chain of grants, an interface per master and per slave. Every handshake is
/// simulated, in the kernel's own time; no instant is computed but by waiting for it. With its
/// constants it comes to the ticks of the law that QueueingArbiter and AccessLaw state.
///
///   MasterInterface --BRn--> LineArbiter --BGn--> GrantSlot --> GrantSlot --> ...
///        |  ^                     ^                   |             |
///        |  +------- BCLR --------+                MasterInterface  MasterInterface
///        +--BBSY, AS, DS, WRITE, address, data--> SlaveInterface, BusTimer
///        <--DTACK, BERR, data--------------------
class SignalEngine : public sc_core::sc_module, public BusEngine {
 public:
  SignalEngine(const sc_core::sc_module_name& name, const VersaBusParameters& parameters,
               const BusParts& parts);

  void enter(int master, Instant request) override;
  void advance() override {}
  void observe_lines(const LineObserver& observer) override { watch_.emplace(observer); }

 private:
  void before_end_of_elaboration() override;
  void make_chain(const BusLine& grant, const std::vector<int>& masters);
  void make_ring();
  void make_master(int master, const BusLine& grant, const BusLine& left, BusLine& right);
  BusLine& make_link(int master);
  void watch_lines();

  unsigned word_bytes_;
  BusLines lines_;
  Settling settling_;
  LineMonitor monitor_;
  LineArbiter arbiter_;
  BusTimer timer_;
  Backpanel panel_;
  std::vector<std::unique_ptr<BusLine>> links_;  // of the chains, by the master that drives them
  std::vector<std::unique_ptr<GrantSlot>> slots_;
  std::vector<std::unique_ptr<MasterInterface>> masters_;  // by number
  std::vector<std::unique_ptr<SlaveInterface>> slaves_;
  std::optional<LineWatch> watch_;
};

}  // namespace maquette::models
