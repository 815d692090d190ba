#include "models/bus/arbitrated_engine.hpp"

#include <algorithm>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

ArbitratedEngine::ArbitratedEngine(const sc_core::sc_module_name& name,
                                   std::unique_ptr<BusArbiter> arbiter, const BusParts& parts)
    : sc_module(name), arbiter_(std::move(arbiter)), parts_(parts), wake_("wake") {
  SC_HAS_PROCESS(ArbitratedEngine);
  SC_METHOD(advance);
  sensitive << wake_;
  dont_initialize();
}

void ArbitratedEngine::enter(int master, Instant request) {
  arbiter_->enter({master, parts_.masters[master].place, request});
}

// Takes every decision that may be taken, in the process of whoever calls: a master, which has
// posted or retires, or the engine's own method, woken.
void ArbitratedEngine::advance() {
  BusLookahead& lookahead = parts_.masters.lookahead();
  const Instant now = kernel_now();
  for (Instant next = arbiter_->next_decision(); next != k_never;
       next = arbiter_->next_decision()) {
    const Instant from = lookahead.decidable_from(next, arbiter_->heeds_unknown(), now);
    if (from > now) {
      if (from != k_never) {
        wake_.notify(to_sc_time(from - now));
      }
      return;
    }
    lookahead.decide(next);
    access(arbiter_->decide());
  }
}

void ArbitratedEngine::access(const BusGrant& granted) {
  BusMasters& masters = parts_.masters;
  const AccessResult result = parts_.slaves.access(masters.burst(granted.master),
                                                   masters[granted.master].access, granted.grant);
  const BusAccess access = masters.access_of(granted, result);
  arbiter_->release(granted, access.end, masters.keeps_bus(access));
  std::optional<Instant> next = masters.finish(access, result.status);
  if (next && !masters.is_observed() && masters.burst(access.master).has_begun()) {
    next = go_on(access, *next);
  }
  if (next) {
    enter(access.master, *next);
  }
}

// After an access of a burst, those that are alike, as far as nobody else can come. Returns when
// the next access is requested, which goes its own way; nothing after the last one.
std::optional<Instant> ArbitratedEngine::go_on(const BusAccess& last, Instant request) {
  BusMasters& masters = parts_.masters;
  BurstProgress& burst = masters.burst(last.master);
  const std::optional<BusSolitude> solitude = arbiter_->solitude();
  if (!solitude) {
    return request;
  }
  BusAccess first = last;
  first.request = first.decision = request;
  first.grant = request + solitude->arbitration;
  first.end = first.grant + (last.end - last.grant);
  first.kept = burst.transaction().block;
  const Duration period = first.end - last.end;
  const Instant until = std::min(
      {solitude->until, masters.lookahead().known_until(kernel_now()), Instant{k_longest_run}});
  const std::int64_t alike = burst.alike();
  const std::int64_t times = std::min(alike, (until - last.end - k_tick) / period);
  if (times <= 0 || !parts_.slaves.repeat(burst, times)) {
    return request;
  }
  const Instant last_decision = request + (times - 1) * period;
  arbiter_->go_on(last_decision, last.end + times * period, first.kept && times < alike);
  masters.lookahead().decide(last_decision);
  return masters.repeat(first, times, period);
}

}  // namespace maquette::models
