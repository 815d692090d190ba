#include "models/bus/signal/access_cycles.hpp"

#include "models/bus/bus_word.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/bus/test_and_set.hpp"

namespace maquette::models {

namespace {

std::uint32_t taken_word(BurstProgress& burst) {
  const unsigned char value = *burst.bytes();
  *burst.bytes() = taken(value);
  const std::uint32_t word = burst.word();
  *burst.bytes() = value;
  return word;
}

TransferEnd read(BurstProgress& burst, BusCycle& cycle) {
  std::uint32_t word = burst.word();
  const TransferEnd end = cycle.read(word);
  put_word(word, burst.bytes(), burst.word_bytes());
  return end;
}

TransferEnd test_and_set(BurstProgress& burst, BusCycle& cycle) {
  const Instant strobe = kernel_now();
  const TransferEnd tested = read(burst, cycle);
  if (tested.is_error) {
    return tested;
  }
  if (burst.transaction().modify > Duration::zero()) {
    sc_core::wait(to_sc_time(burst.transaction().modify));
  }
  const Duration until_write = kernel_now() - strobe;
  const TransferEnd set = cycle.write(taken_word(burst));
  return set.is_error ? TransferEnd{until_write + set.slave_time, true} : tested;
}

TransferEnd transfer(BurstProgress& burst, BusCycle& cycle) {
  return burst.burst().is_write() ? cycle.write(burst.word()) : read(burst, cycle);
}

tlm::tlm_response_status status_of(const TransferEnd& end, std::uint64_t address,
                                   const AddressMap& map) {
  if (!end.is_error) {
    return tlm::TLM_OK_RESPONSE;
  }
  return map.find(address) == AddressMap::k_unmapped ? tlm::TLM_ADDRESS_ERROR_RESPONSE
                                                     : tlm::TLM_GENERIC_ERROR_RESPONSE;
}

}  // namespace

AccessResult do_access(BurstProgress& burst, const AddressMap& map, BusCycle& cycle) {
  const Instant strobe = kernel_now();
  cycle.begin(burst.address());
  const TransferEnd end =
      burst.transaction().test_and_set ? test_and_set(burst, cycle) : transfer(burst, cycle);
  cycle.end();
  return {kernel_now() - strobe, end.slave_time, status_of(end, burst.address(), map)};
}

}  // namespace maquette::models
