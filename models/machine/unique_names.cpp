#include "models/machine/unique_names.hpp"

#include <systemc>

namespace maquette::models {

void require_unique_names() {
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_INSTANCE_EXISTS_, sc_core::SC_THROW);
}

}  // namespace maquette::models
