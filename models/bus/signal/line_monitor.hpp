#pragma once

#include "models/bus/bus_account.hpp"
#include "models/bus/request_queue.hpp"

namespace maquette::models {

/// Looks on while boards take the bus in turn, and keeps the account of queues and occupation. It
/// decides nothing.
class LineMonitor {
 public:
  /// The account is kept by reference.
  explicit LineMonitor(BusAccount& account) : account_(account) {}

  /// A master's request is known, of an instant that is not past.
  void enter(const Contender& contender) { requests_.insert(contender); }

  /// The present instant gives the bus to a master, which keeps or is granted it. Returns whether
  /// the master of the access before had kept the bus until now.
  bool decide(int master, Instant now);

  /// An access of a master, decided on at `decision`, ends now; whether its master keeps the bus.
  void release(int master, Instant decision, Instant now, bool keeps);

 private:
  BusAccount& account_;
  RequestQueue requests_;
  int holder_ = k_nobody;  // keeps the bus between two accesses
  Instant free_at_{};
};

}  // namespace maquette::models
