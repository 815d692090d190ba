#include "models/bus/signal/line_arbiter.hpp"

namespace maquette::models {

namespace {

constexpr int k_none = -1;

}  // namespace

LineArbiter::LineArbiter(const sc_core::sc_module_name& name, const ArbitrationPolicy& policy,
                         BusLines& lines, Settling& settling)
    : sc_module(name),
      is_ring_(policy.chain == GrantChain::ring),
      lines_(lines),
      settling_(settling),
      granted_level_("granted_level", k_none) {
  SC_HAS_PROCESS(LineArbiter);
  SC_THREAD(run);
  for (const BusLine& request : lines_.request) {
    any_request_ |= request.value_changed_event();
  }
  if (policy.clears_bus) {
    SC_METHOD(clear);
    sensitive << lines_.busy << granted_level_;
    for (const BusLine& request : lines_.request) {
      sensitive << request;
    }
  }
}

int LineArbiter::highest_request() const {
  int level = BusLines::k_levels - 1;
  while (level > k_none && !is_low(lines_.request[static_cast<std::size_t>(level)])) {
    --level;
  }
  return level;
}

void LineArbiter::wait_for_request() const {
  while (highest_request() == k_none) {
    sc_core::wait(any_request_);
  }
}

void LineArbiter::run() {
  for (;;) {
    wait_for_high(lines_.busy);
    wait_for_request();
    settling_.wait();
    const int level = highest_request();
    granted_level_.write(level);
    BusLine& grant = lines_.grant[is_ring_ ? 0 : static_cast<std::size_t>(level)];
    pull(grant);
    wait_for_low(lines_.busy);
    let_go(grant);
  }
}

void LineArbiter::clear() {
  is_low(lines_.busy) && highest_request() > granted_level_.read() ? pull(lines_.clear)
                                                                   : let_go(lines_.clear);
}

}  // namespace maquette::models
