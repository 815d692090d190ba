#include "models/bus/signal/slave_interface.hpp"

#include "models/bus/bus_word.hpp"
#include "models/bus/kernel_time.hpp"

namespace maquette::models {

SlaveInterface::SlaveInterface(const sc_core::sc_module_name& name, int slave, unsigned word_bytes,
                               BusSlaves& slaves, BusLines& lines)
    : sc_module(name), slave_(slave), slaves_(slaves), lines_(lines), bytes_(word_bytes) {
  payload_.set_extension(&strobe_);
  payload_.set_data_ptr(bytes_.data());
  payload_.set_data_length(word_bytes);
  payload_.set_streaming_width(word_bytes);
  SC_HAS_PROCESS(SlaveInterface);
  SC_THREAD(run);
}

void SlaveInterface::run() {
  for (;;) {
    wait_for_strobe();
    if (is_strobed_after(transfer())) {
      answer();
    }
  }
}

void SlaveInterface::wait_for_strobe() const {
  const AddressRange& range = slaves_.address_map()[slave_];
  do {
    sc_core::wait(lines_.upper_strobe.value_changed_event());
  } while (!is_strobed(lines_) || !range.contains(lines_.address.read()));
}

Duration SlaveInterface::transfer() {
  const bool writes = is_low(lines_.write);
  if (writes) {
    put_word(lines_.data.read(), bytes_.data(), bytes_.size());
  }
  payload_.set_command(writes ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
  payload_.set_address(lines_.address.read() - slaves_.address_map()[slave_].base);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  strobe_.instant = kernel_now();
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  slaves_.transport(slave_, payload_, delay);
  return to_duration(delay);
}

bool SlaveInterface::is_strobed_after(Duration access_time) const {
  if (access_time > Duration::zero()) {
    sc_core::wait(to_sc_time(access_time), lines_.upper_strobe.value_changed_event());
  }
  return is_strobed(lines_);
}

void SlaveInterface::answer() {
  if (payload_.is_read()) {
    lines_.data.write(word_of(bytes_.data(), bytes_.size()));
  }
  pull(lines_.acknowledge);
  if (!payload_.is_response_ok()) {
    pull(lines_.error);
  }
  wait_for_high(lines_.upper_strobe);
  let_go(lines_.acknowledge);
  let_go(lines_.error);
}

}  // namespace maquette::models
