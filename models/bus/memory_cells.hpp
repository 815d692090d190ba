#pragma once

#include <tlm>
#include <vector>

namespace maquette::models {

/// Reads or writes a memory's bytes as the payload asks and answers it, with an address error
/// beyond their end. Returns the number of bytes moved.
unsigned access_cells(std::vector<unsigned char>& cells, tlm::tlm_generic_payload& payload);

}  // namespace maquette::models
