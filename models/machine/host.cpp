#include "models/machine/host.hpp"

#include <stdexcept>

#include "models/bus/bus_error.hpp"
#include "models/bus/kernel_time.hpp"

namespace maquette::models {

Host::Host(const sc_core::sc_module_name& name, const HostParameters& parameters,
           const Kvm02Parameters& interface, std::vector<Backplane> backplanes,
           sc_core::sc_event& start)
    : sc_module(name),
      bus_masters("bus_master", backplanes.size()),
      access_law_{Period::of_frequency(parameters.clock_hz), interface.access_clocks,
                  interface.access_slack},
      word_time_(access_law_.clock.times(parameters.word_clocks)),
      backplanes_(std::move(backplanes)),
      masters_(backplanes_.size(), k_nobody),
      start_(start) {
  if (parameters.word_clocks < 0) {
    throw std::invalid_argument("times of the host must not be negative");
  }
  transaction_.gap = word_time_;
  transaction_.runs_ahead = true;
  SC_HAS_PROCESS(Host);
  SC_THREAD(run);
}

void Host::run() {
  for (const Backplane& backplane : backplanes_) {
    for (const int board : backplane.boards) {
      backplane.bus.retire(board);
    }
  }
  for (std::size_t i = 0; i < backplanes_.size(); ++i) {
    for (LoadImage& image : backplanes_[i].images) {
      if (!image.bytes.empty()) {
        load(i, image);
      }
    }
    backplanes_[i].bus.retire(masters_[i]);
  }
  for (const Backplane& backplane : backplanes_) {
    for (const int board : backplane.boards) {
      backplane.bus.activate(board);
    }
  }
  statistics_.finished = kernel_now();
  start_.notify(sc_core::SC_ZERO_TIME);
}

void Host::load(std::size_t backplane, LoadImage& image) {
  const std::size_t word = backplanes_[backplane].bus.word_bytes();
  image.bytes.resize((image.bytes.size() + word - 1) / word * word);
  tlm::tlm_generic_payload payload;
  payload.set_extension(&transaction_);
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  payload.set_address(image.base);
  payload.set_data_ptr(image.bytes.data());
  payload.set_data_length(static_cast<unsigned>(image.bytes.size()));
  payload.set_streaming_width(static_cast<unsigned>(image.bytes.size()));
  sc_core::sc_time delay = to_sc_time(word_time_);
  bus_masters[backplane]->b_transport(payload, delay);
  require_answer(payload, transaction_, name());
  statistics_.words += transaction_.accesses;
  statistics_.waited += transaction_.waited;
  statistics_.transferred += transaction_.transferred;
}

}  // namespace maquette::models
