#include "models/bus/signal/grant_slot.hpp"

namespace maquette::models {

GrantSlot::GrantSlot(const sc_core::sc_module_name& name, const BusLine& arbiter,
                     const BusLine& left, BusLine& right)
    : sc_module(name),
      arbiter_(arbiter),
      left_(left),
      right_(right),
      wants_("wants"),
      has_grant_("has_grant"),
      starts_("starts") {
  SC_HAS_PROCESS(GrantSlot);
  SC_METHOD(pass);
  sensitive << arbiter << left << wants_ << starts_;
}

void GrantSlot::pass() {
  const bool has_come = is_low(left_);
  if (has_come && !had_come_) {
    takes_ = wants_.read();
  }
  had_come_ = has_come;
  has_grant_.write(has_come && takes_);
  const bool passes = starts_.read() ? is_low(arbiter_) : has_come && !takes_;
  passes ? pull(right_) : let_go(right_);
}

void GrantSlot::wait_for_grant() const {
  while (!has_grant_.read()) {
    sc_core::wait(has_grant_.value_changed_event());
  }
}

}  // namespace maquette::models
