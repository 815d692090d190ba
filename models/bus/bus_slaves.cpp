#include "models/bus/bus_slaves.hpp"

#include <algorithm>

#include "models/bus/kernel_time.hpp"
#include "models/bus/test_and_set.hpp"

namespace maquette::models {

namespace {

/// Whether an address is one of the two after it, as those of the words of a register are that is
/// written again and again.
bool is_overwritten(const std::uint64_t* address, const std::uint64_t* end) {
  return (address + 1 < end && address[1] == *address) ||
         (address + 2 < end && address[2] == *address);
}

}  // namespace

void BusSlaves::attach(tlm::tlm_base_target_socket<>& socket, const AddressRange& range) {
  address_map_.add(range);
  sockets_.bind(socket);
}

AccessResult BusSlaves::access(BurstProgress& burst, const AccessLaw& law, Instant strobe) {
  return burst.transaction().test_and_set
             ? test_and_set(burst, law, strobe)
             : transfer(burst, law, strobe, burst.burst().get_command());
}

AccessResult BusSlaves::transfer(BurstProgress& burst, const AccessLaw& law, Instant strobe,
                                 tlm::tlm_command command) {
  const std::uint64_t address = burst.address();
  const int slave = address_map_.find(address);
  if (slave == AddressMap::k_unmapped) {
    const bool times_out = timeout_ > Duration::zero();
    return {times_out ? timeout_ : law.duration({}), timeout_, tlm::TLM_ADDRESS_ERROR_RESPONSE};
  }
  tlm::tlm_generic_payload& access =
      burst.access_of_slave(address - address_map_[slave].base, strobe);
  access.set_command(command);
  const Duration offset = std::max(strobe - kernel_now(), Duration::zero());
  sc_core::sc_time delay = to_sc_time(offset);
  transport(slave, access, delay);
  const Duration slave_time = to_duration(delay) - offset;
  if (timeout_ > Duration::zero() && slave_time > timeout_) {
    return {timeout_, timeout_, tlm::TLM_GENERIC_ERROR_RESPONSE};
  }
  return {law.duration(slave_time), slave_time, access.get_response_status()};
}

// Reads, lets the processor change the first byte, and writes, under one grant: the bus is not
// released in between, whoever asks (MC68000 TAS). The burst keeps what was read.
AccessResult BusSlaves::test_and_set(BurstProgress& burst, const AccessLaw& law, Instant strobe) {
  const AccessResult read = transfer(burst, law, strobe, tlm::TLM_READ_COMMAND);
  if (read.status != tlm::TLM_OK_RESPONSE) {
    return read;
  }
  unsigned char& first_byte = *burst.bytes();
  const unsigned char value = first_byte;
  const Duration until_write = read.duration + burst.transaction().modify;
  first_byte = taken(value);
  const AccessResult write = transfer(burst, law, strobe + until_write, tlm::TLM_WRITE_COMMAND);
  first_byte = value;
  const bool is_written = write.status == tlm::TLM_OK_RESPONSE;
  return {until_write + write.duration,
          is_written ? read.slave_time : until_write + write.slave_time, write.status};
}

bool BusSlaves::repeat(BurstProgress& burst, std::int64_t times) {
  const int slave = address_map_.find(burst.address_after(-1));
  const AddressRange& range = address_map_[slave];
  if (!range.is_steady) {
    return false;
  }
  if (burst.is_consecutive()) {
    if (!range.contains(burst.address_after(times - 1))) {
      return false;
    }
    write(slave, burst, 0, times);
    return true;
  }
  const std::uint64_t* const first = burst.addresses();
  const std::uint64_t* const end = first + times;
  if (!std::all_of(first, end, [&](std::uint64_t address) { return range.contains(address); })) {
    return false;
  }
  for (const std::uint64_t* address = first; address != end; ++address) {
    if (!is_overwritten(address, end)) {
      write(slave, burst, address - first, 1);
    }
  }
  return true;
}

void BusSlaves::write(int slave, BurstProgress& burst, std::int64_t first, std::int64_t accesses) {
  const auto length = static_cast<unsigned>(accesses * burst.word_bytes());
  repeated_.set_address(burst.address_after(first) - address_map_[slave].base);
  repeated_.set_data_ptr(burst.bytes_after(first));
  repeated_.set_data_length(length);
  repeated_.set_streaming_width(length);
  repeated_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  sc_core::sc_time ignored;
  transport(slave, repeated_, ignored);
}

unsigned BusSlaves::transport_dbg(tlm::tlm_generic_payload& payload) {
  const std::uint64_t address = payload.get_address();
  const int slave = address_map_.find(address);
  if (slave == AddressMap::k_unmapped) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return 0;
  }
  payload.set_address(address - address_map_[slave].base);
  const unsigned bytes = sockets_[slave]->transport_dbg(payload);
  payload.set_address(address);
  return bytes;
}

}  // namespace maquette::models
