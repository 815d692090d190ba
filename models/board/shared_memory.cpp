#include "models/board/shared_memory.hpp"

#include <stdexcept>

#include "models/bus/kernel_time.hpp"
#include "models/bus/memory_cells.hpp"

namespace maquette::models {

SharedMemory::SharedMemory(const sc_core::sc_module_name& name,
                           const SharedMemoryParameters& parameters, std::size_t size_bytes,
                           int ports)
    : sc_module(name), bus_ports("bus_port", static_cast<std::size_t>(ports)), cells_(size_bytes) {
  if (parameters.access_time < Duration::zero()) {
    throw std::invalid_argument("the access time of the shared memory must not be negative");
  }
  access_time_ = to_sc_time(parameters.access_time);
  for (auto& port : bus_ports) {
    port.register_b_transport(this, &SharedMemory::b_transport);
    port.register_transport_dbg(this, &SharedMemory::transport_dbg);
  }
}

void SharedMemory::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  access_cells(cells_, payload);
  delay += access_time_;
}

unsigned SharedMemory::transport_dbg(tlm::tlm_generic_payload& payload) {
  return access_cells(cells_, payload);
}

}  // namespace maquette::models
