#include "models/bus/signal/settling.hpp"

#include <systemc>

#include "models/bus/bus_misuse.hpp"
#include "models/bus/kernel_time.hpp"

namespace maquette::models {

void Settling::wait() {
  for (int cycle = 0; cycle < k_delta_cycles; ++cycle) {
    sc_core::wait(sc_core::SC_ZERO_TIME);
  }
  settled_ = kernel_now();
}

void Settling::check(Instant request, const std::string& master) const {
  if (request <= settled_) {
    report_misuse("master " + master + " requests more than " + std::to_string(k_delta_cycles) +
                  " delta cycles late in its instant");
  }
}

}  // namespace maquette::models
