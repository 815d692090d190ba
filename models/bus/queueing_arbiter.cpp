#include "models/bus/queueing_arbiter.hpp"

#include <algorithm>
#include <stdexcept>

#include "models/bus/period.hpp"

namespace maquette::models {

QueueingArbiter::QueueingArbiter(const VersaBusParameters& parameters, Duration quantum,
                                 BusAccount& account)
    : policy_(parameters.arbitration), quantum_(quantum), account_(account) {
  const Period clock = Period::of_frequency(parameters.clock_hz);
  arbitration_ = clock.times(parameters.arbitration_clocks);
  handover_ =
      clock.times(parameters.arbitration_clocks + parameters.handover_clocks) - arbitration_;
}

void QueueingArbiter::enter(const Contender& contender) {
  requests_.insert(contender);
  if (contender.request < free_at_) {  // into an access that was decided before it was known
    account_.found_occupied(contender.master, previous_, free_at_ - contender.request);
  }
}

Instant QueueingArbiter::next_decision() const {
  if (is_in_turn()) {
    return requests_.request_of(runner_);
  }
  if (holder_ != k_nobody) {
    return std::min(requests_.request_of(holder_), earliest_clear_request());
  }
  const Instant earliest = requests_.earliest();
  return earliest == k_never ? k_never : std::max(earliest, free_at_);
}

Instant QueueingArbiter::earliest_clear_request() const {
  if (policy_.clears_bus) {
    const Contender& holder = requests_.of(holder_);
    for (const Contender& other : requests_.up_to(holder.request)) {
      if (other.place.level > holder.place.level) {
        return std::max(other.request, free_at_);
      }
    }
  }
  return k_never;
}

bool QueueingArbiter::keeps_at(Instant instant) const {
  return is_in_turn() || earliest_clear_request() > instant;
}

Instant QueueingArbiter::quantum_end(Instant instant) const {
  return quantum_ == Duration::zero() ? instant : (instant / quantum_ + 1) * quantum_;
}

BusGrant QueueingArbiter::decide() {
  const Instant instant = next_decision();
  if (instant < last_decision_ || instant < free_at_) {
    throw std::logic_error("bus time runs backwards");
  }
  last_decision_ = instant;
  const Contenders standing = requests_.up_to(instant);
  account_.decide(instant, standing);
  const bool kept = holder_ != k_nobody;
  if (kept || is_in_turn()) {  // the others wait for it between its accesses as well
    account_.occupy(previous_, free_at_, instant, standing);
  }
  if (kept) {
    account_.keep(holder_, instant - free_at_);
    if (keeps_at(instant)) {
      return granted(holder_, instant, {}, {}, kept);
    }
    holder_ = k_nobody;
    free_at_ = instant;
  }
  const int winner = is_in_turn() ? runner_ : policy_.choose(standing, previous_);
  const bool hands_over = previous_ != k_nobody && previous_ != winner;
  return granted(winner, instant, arbitration_, hands_over ? handover_ : Duration{}, kept);
}

BusGrant QueueingArbiter::granted(int master, Instant decision, Duration arbitration,
                                  Duration handover, bool kept) {
  const Instant request = requests_.request_of(master);
  if (!is_in_turn()) {
    runner_ = master;
    turn_end_ = quantum_end(decision);
  }
  requests_.remove(master);
  return {master, request, decision, decision + arbitration + handover, kept, handover};
}

void QueueingArbiter::release(const BusGrant& granted, Instant end, bool keeps) {
  account_.occupy(granted.master, granted.decision, end, requests_.up_to(end));
  free_at_ = end;
  previous_ = granted.master;
  holder_ = keeps ? granted.master : k_nobody;
}

std::optional<BusSolitude> QueueingArbiter::solitude() const {
  if (quantum_ != Duration::zero()) {
    return std::nullopt;
  }
  return BusSolitude{requests_.earliest(), holder_ == k_nobody ? arbitration_ : Duration::zero()};
}

void QueueingArbiter::go_on(Instant last_decision, Instant last_end, bool keeps) {
  last_decision_ = last_decision;
  free_at_ = last_end;
  holder_ = keeps ? previous_ : k_nobody;
}

}  // namespace maquette::models
