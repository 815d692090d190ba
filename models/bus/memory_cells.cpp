#include "models/bus/memory_cells.hpp"

#include <algorithm>
#include <cstdint>

namespace maquette::models {

unsigned access_cells(std::vector<unsigned char>& cells, tlm::tlm_generic_payload& payload) {
  const std::uint64_t address = payload.get_address();
  const std::uint64_t bytes = payload.get_data_length();
  if (address >= cells.size() || bytes > cells.size() - address) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return 0;
  }
  unsigned char* place = cells.data() + address;
  unsigned char* data = payload.get_data_ptr();
  if (payload.is_read()) {
    std::copy_n(place, bytes, data);
  } else {
    std::copy_n(data, bytes, place);
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  return static_cast<unsigned>(bytes);
}

}  // namespace maquette::models
