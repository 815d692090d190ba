#include "models/bus/bus_error.hpp"

#include <sstream>
#include <systemc>

namespace maquette::models {

void require_answer(const tlm::tlm_generic_payload& burst, const BusTransaction& transaction,
                    const std::string& master) {
  if (burst.is_response_ok()) {
    return;
  }
  std::ostringstream text;
  text << "bus error: master " << master << ", address 0x" << std::hex << transaction.failed_address
       << ", at " << sc_core::sc_time_stamp() << " (" << burst.get_response_string() << ')';
  SC_REPORT_ERROR("/maquette/bus_error", text.str().c_str());
}

}  // namespace maquette::models
