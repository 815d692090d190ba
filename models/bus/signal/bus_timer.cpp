#include "models/bus/signal/bus_timer.hpp"

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

BusTimer::BusTimer(const sc_core::sc_module_name& name, Duration timeout, const AddressMap& map,
                   BusLines& lines)
    : sc_module(name), timeout_(timeout), map_(map), lines_(lines) {
  SC_HAS_PROCESS(BusTimer);
  SC_THREAD(run);
}

void BusTimer::run() {
  for (;;) {
    wait_for_low(lines_.upper_strobe);
    timeout_ > Duration::zero() ? time() : answer_vacancy();
    wait_for_high(lines_.upper_strobe);
    let_go(lines_.acknowledge);
    let_go(lines_.error);
  }
}

void BusTimer::time() {
  sc_core::wait(to_sc_time(timeout_), lines_.upper_strobe.value_changed_event());
  sc_core::wait(sc_core::SC_ZERO_TIME);  // an answer of this instant is on its way
  if (is_low(lines_.upper_strobe) && !is_low(lines_.acknowledge)) {
    pull(lines_.error);
  }
}

void BusTimer::answer_vacancy() {
  if (map_.find(lines_.address.read()) == AddressMap::k_unmapped) {
    pull(lines_.acknowledge);
    pull(lines_.error);
  }
}

}  // namespace maquette::models
