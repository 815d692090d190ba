#pragma once

#include "models/bus/bus_arbiter.hpp"
#include "models/bus/request_queue.hpp"

namespace maquette::models {

/// A bus that everybody has at once: each request is granted in its own instant, whoever else has
/// the bus, without arbitration. Nobody waits, and accesses overlap.
class IdealArbiter : public BusArbiter {
 public:
  void enter(const Contender& contender) override { requests_.insert(contender); }
  [[nodiscard]] Instant next_decision() const override { return requests_.earliest(); }
  [[nodiscard]] bool heeds_unknown() const override { return false; }

  BusGrant decide() override {
    const Instant instant = requests_.earliest();
    const int master = requests_.up_to(instant).first->master;
    requests_.remove(master);
    return {master, instant, instant, instant};
  }

  void release(const BusGrant& /*granted*/, Instant /*end*/, bool /*keeps*/) override {}

 private:
  RequestQueue requests_;
};

}  // namespace maquette::models
