#include "models/host.hpp"

#include <stdexcept>

#include "models/bus_error.hpp"
#include "models/kernel_time.hpp"

namespace maquette::models {

namespace {

AccessLaw access_law(const HostParameters& host, const Kvm02Parameters& interface) {
  return {Period::of_frequency(host.clock_hz), interface.access_clocks, interface.access_slack};
}

}  // namespace

Host::Host(const sc_core::sc_module_name& name, const HostParameters& parameters,
           const Kvm02Parameters& interface, VersaBus& bus, std::vector<int> boards,
           std::vector<LoadImage> images, sc_core::sc_event& start)
    : sc_module(name),
      bus_master("bus_master"),
      word_time_(Period::of_frequency(parameters.clock_hz).times(parameters.word_clocks)),
      bus_(bus),
      master_(bus.attach_master(
          bus_master, {this->name(), parameters.place, access_law(parameters, interface)})),
      boards_(std::move(boards)),
      images_(std::move(images)),
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
  for (const int board : boards_) {
    bus_.retire(board);
  }
  for (LoadImage& image : images_) {
    if (!image.bytes.empty()) {
      load(image);
    }
  }
  bus_.retire(master_);
  for (const int board : boards_) {
    bus_.activate(board);
  }
  statistics_.finished = kernel_now();
  start_.notify(sc_core::SC_ZERO_TIME);
}

void Host::load(LoadImage& image) {
  const std::size_t word = bus_.word_bytes();
  image.bytes.resize((image.bytes.size() + word - 1) / word * word);
  tlm::tlm_generic_payload payload;
  payload.set_extension(&transaction_);
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  payload.set_address(image.base);
  payload.set_data_ptr(image.bytes.data());
  payload.set_data_length(static_cast<unsigned>(image.bytes.size()));
  payload.set_streaming_width(static_cast<unsigned>(image.bytes.size()));
  sc_core::sc_time delay = to_sc_time(word_time_);
  bus_master->b_transport(payload, delay);
  require_answer(payload, transaction_, name());
  statistics_.words += transaction_.accesses;
  statistics_.waited += transaction_.waited;
  statistics_.transferred += transaction_.transferred;
}

}  // namespace maquette::models
