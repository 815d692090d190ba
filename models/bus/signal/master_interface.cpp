#include "models/bus/signal/master_interface.hpp"

#include "models/bus/kernel_time.hpp"
#include "models/bus/signal/access_cycles.hpp"

namespace maquette::models {

namespace {

// What follows up a burst computes in this process (BusTransaction::follow_up): pixels.
constexpr std::size_t k_stack_bytes = std::size_t{1} << 20U;

}  // namespace

MasterInterface::MasterInterface(const sc_core::sc_module_name& name, int master,
                                 const Backpanel& panel, GrantSlot& slot)
    : sc_module(name),
      master_(master),
      panel_(panel),
      slot_(slot),
      request_line_(
          panel.lines.request[static_cast<std::size_t>(panel.parts.masters[master].place.level)]),
      cycle_(panel.parts.masters[master].access, panel.lines),
      posted_("posted") {
  SC_HAS_PROCESS(MasterInterface);
  SC_THREAD(run);
  set_stack_size(k_stack_bytes);
  SC_METHOD(watch_busy);
  sensitive << panel.lines.busy;
  dont_initialize();
}

// ---- requests ----

void MasterInterface::enter(Instant request) {
  panel_.settling.check(request, panel_.parts.masters[master_].name);
  know(request);
  posted_.notify();
}

void MasterInterface::know(Instant request) {
  request_ = request;
  panel_.monitor.enter({master_, panel_.parts.masters[master_].place, request});
}

void MasterInterface::wait_for_request() {
  while (request_ == k_never) {
    wait(posted_);
  }
  if (request_ > kernel_now()) {
    wait(to_sc_time(request_ - kernel_now()));
  }
}

// ---- the bus ----

void MasterInterface::run() {
  for (;;) {
    wait_for_request();
    BusGrant granted = win();
    while (access(granted) && keep_until_request()) {
      const Instant now = kernel_now();
      granted = {master_, request_, now, now, panel_.monitor.decide(master_, now)};
    }
    release();
  }
}

// Requests the bus until the grant has come down the chain and the arbitration's clocks are over;
// BBSY then tells the arbiter to take the grant back.
BusGrant MasterInterface::win() {
  slot_.want(true);
  pull(request_line_);
  slot_.wait_for_grant();
  const Instant decision = kernel_now();
  const bool kept = panel_.monitor.decide(master_, decision);
  const bool hands_over = predecessor_ == Predecessor::another;
  const Duration arbitration = panel_.clocks.duration(hands_over);
  if (arbitration > Duration::zero()) {
    wait(to_sc_time(arbitration));
  }
  has_bus_ = true;
  pull(panel_.lines.busy);
  slot_.want(false);
  let_go(request_line_);
  return {master_,  request_,
          decision, kernel_now(),
          kept,     hands_over ? arbitration - panel_.clocks.duration(false) : Duration{}};
}

void MasterInterface::release() {
  has_bus_ = false;
  predecessor_ = Predecessor::itself;
  slot_.start_ring(panel_.is_ring);
  let_go(panel_.lines.busy);
}

void MasterInterface::watch_busy() {
  if (is_low(panel_.lines.busy) && !has_bus_) {
    predecessor_ = Predecessor::another;
    slot_.start_ring(false);
  }
}

// Between two accesses of a block; false when BCLR ends it.
bool MasterInterface::keep_until_request() {
  const BusLine& clear = panel_.lines.clear;
  while (!is_low(clear) && request_ > kernel_now()) {
    wait(to_sc_time(request_ - kernel_now()), clear.value_changed_event());
  }
  if (!is_low(clear)) {
    panel_.settling.wait();
  }
  return !is_low(clear);
}

// ---- one access ----

// Returns whether the board keeps the bus after it.
bool MasterInterface::access(const BusGrant& granted) {
  BusMasters& masters = panel_.parts.masters;
  request_ = k_never;
  const AccessResult result =
      do_access(masters.burst(master_), panel_.parts.slaves.address_map(), cycle_);
  const BusAccess done = masters.access_of(granted, result);
  const bool keeps = masters.keeps_bus(done);
  panel_.monitor.release(master_, granted.decision, done.end, keeps);
  if (const std::optional<Instant> next = masters.finish(done, result.status)) {
    know(*next);
  }
  return keeps;
}

}  // namespace maquette::models
