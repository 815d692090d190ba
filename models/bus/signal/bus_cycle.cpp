#include "models/bus/signal/bus_cycle.hpp"

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

void BusCycle::begin(std::uint64_t address) {
  lines_.address.write(address);
  pull(lines_.address_strobe);
}

void BusCycle::end() {
  let_go(lines_.address_strobe);
  let_go(lines_.write);
}

TransferEnd BusCycle::write(std::uint32_t word) {
  pull(lines_.write);
  lines_.data.write(word);
  const TransferEnd end = strobe();
  release();
  return end;
}

TransferEnd BusCycle::read(std::uint32_t& word) {
  let_go(lines_.write);
  const TransferEnd end = strobe();
  if (!end.is_error) {
    word = lines_.data.read();
  }
  release();
  return end;
}

// Until the clock at whose end the processor takes the word and lets the strobes rise.
TransferEnd BusCycle::strobe() {
  const Instant start = kernel_now();
  pull(lines_.upper_strobe);
  pull(lines_.lower_strobe);
  wait_for_answer();
  const Duration slave_time = kernel_now() - start;
  if (is_low(lines_.acknowledge)) {
    wait_out_clocks(start);
  }
  return {slave_time, is_low(lines_.error)};
}

void BusCycle::wait_for_answer() const {
  while (!is_low(lines_.acknowledge) && !is_low(lines_.error)) {
    sc_core::wait(lines_.acknowledge.value_changed_event() | lines_.error.value_changed_event());
  }
}

// DTACK has just fallen: counts the looks that have missed it, and the clocks that are over by now.
void BusCycle::wait_out_clocks(Instant strobe) const {
  Clocks waits = 0;
  while (strobe + law_.access_slack + law_.clock.times(waits) < kernel_now()) {
    ++waits;
  }
  Clocks clocks = law_.access_clocks + waits;
  while (strobe + law_.clock.times(clocks) < kernel_now()) {
    ++clocks;
  }
  if (const Instant end = strobe + law_.clock.times(clocks); end > kernel_now()) {
    sc_core::wait(to_sc_time(end - kernel_now()));
  }
}

void BusCycle::release() {
  let_go(lines_.upper_strobe);
  let_go(lines_.lower_strobe);
  wait_for_high(lines_.acknowledge);
  wait_for_high(lines_.error);
}

}  // namespace maquette::models
