#include "models/bus/arbitrated_engine.hpp"

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
  if (const std::optional<Instant> next = masters.finish(access, result.status)) {
    enter(access.master, *next);
  }
}

}  // namespace maquette::models
