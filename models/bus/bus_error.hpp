#pragma once

#include <string>
#include <tlm>

#include "models/bus/bus_transaction.hpp"

namespace maquette::models {

/// Reports a bus error (an exception out of the kernel's run: master, address, instant) when a
/// finished burst has an error response. Called at the burst's end.
void require_answer(const tlm::tlm_generic_payload& burst, const BusTransaction& transaction,
                    const std::string& master);

}  // namespace maquette::models
