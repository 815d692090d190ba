#pragma once

#include <memory>
#include <systemc>

#include "models/bus/bus_arbiter.hpp"
#include "models/bus/bus_engine.hpp"

namespace maquette::models {

/// The engine of the levels at which an access is one decision of a BusArbiter: it says who has the
/// bus from when on; the access then goes to its slave, for as long as AccessLaw says. The engine
/// keeps the bus's own time: BusLookahead says how far it may be ahead of the kernel. Accesses of a
/// burst that are alike, with nobody else there, are done in one go, to the same ticks.
class ArbitratedEngine : public sc_core::sc_module, public BusEngine {
 public:
  ArbitratedEngine(const sc_core::sc_module_name& name, std::unique_ptr<BusArbiter> arbiter,
                   const BusParts& parts);

  void enter(int master, Instant request) override;
  void advance() override;

 private:
  void access(const BusGrant& granted);
  [[nodiscard]] std::optional<Instant> go_on(const BusAccess& last, Instant request);

  std::unique_ptr<BusArbiter> arbiter_;
  BusParts parts_;
  sc_core::sc_event wake_;
};

}  // namespace maquette::models
