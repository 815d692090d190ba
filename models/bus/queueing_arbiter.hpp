#pragma once

#include "models/bus/bus_account.hpp"
#include "models/bus/bus_arbiter.hpp"
#include "models/bus/request_queue.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

/// A bus that one master has at a time, and for which the others queue.
///
/// A master's request stands from its instant R. Arbitration starts at S = max(R, end of the
/// previous access); of all requests up to S the policy picks one, which is granted the bus at
/// G = S + arbitration_clocks (+ handover_clocks when another master had the bus before). A burst
/// that keeps the bus (BBSY) needs no arbitration after its first access; under a policy
/// that clears the bus a request of a strictly higher level (BCLR) makes its master release the bus
/// at the end of the current access, or at once when it is between two accesses, and arbitrate
/// again. Assumption: a first grant pays no hand-over.
///
/// With a quantum the masters are decoupled in time (IEEE 1666-2011, section 12): time is cut into
/// quanta, and the master that has won an arbitration has its turn until the end of the quantum in
/// which it began. What it requests until then is granted as though nobody else were there; the
/// others stand until its turn is over. A quantum no longer than the shortest access decides
/// nothing so, and is exact.
class QueueingArbiter : public BusArbiter {
 public:
  /// Exact with a quantum of zero. The account is kept by reference.
  QueueingArbiter(const VersaBusParameters& parameters, Duration quantum, BusAccount& account);

  void enter(const Contender& contender) override;
  [[nodiscard]] Instant next_decision() const override;
  [[nodiscard]] bool heeds_unknown() const override { return !is_in_turn(); }
  BusGrant decide() override;
  void release(const BusGrant& granted, Instant end, bool keeps) override;
  [[nodiscard]] std::optional<BusSolitude> solitude() const override;
  void go_on(Instant last_decision, Instant last_end, bool keeps) override;

 private:
  [[nodiscard]] bool is_in_turn() const {
    return quantum_ > Duration::zero() && requests_.request_of(runner_) < turn_end_;
  }
  [[nodiscard]] Instant earliest_clear_request() const;
  [[nodiscard]] bool keeps_at(Instant instant) const;
  [[nodiscard]] Instant quantum_end(Instant instant) const;
  BusGrant granted(int master, Instant decision, Duration arbitration, Duration handover,
                   bool kept);

  ArbitrationPolicy policy_;
  Duration arbitration_;
  Duration handover_;
  Duration quantum_;
  BusAccount& account_;

  RequestQueue requests_;
  int holder_ = k_nobody;    // keeps the bus between two accesses
  int previous_ = k_nobody;  // had the bus last
  Instant free_at_{};
  Instant last_decision_{-1};
  int runner_ = k_nobody;  // had its turn last
  Instant turn_end_{};
};

}  // namespace maquette::models
