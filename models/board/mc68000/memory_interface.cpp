#include "models/board/mc68000/memory_interface.hpp"

#include <stdexcept>
#include <utility>

#include "models/board/mc68000/stop.hpp"

namespace maquette::models::mc68000 {

namespace {

using Kind = BusRequest::Kind;

void check_even(OperandSize size, std::uint32_t place) {
  if (size != OperandSize::byte && (place & 1U) != 0) {
    throw Fault{StopReason::odd_address, place};
  }
}

Account counts(Kind kind, OperandSize size, unsigned wait_cycles) {
  const unsigned words = words_of(size);
  Account access;
  access.bus_wait_cycles = wait_cycles;
  if (kind == Kind::fetch) {
    access.bus_fetches = words;
  }
  if (kind == Kind::read || kind == Kind::test_and_set) {
    access.bus_reads = words;
  }
  if (kind == Kind::write || kind == Kind::test_and_set) {
    access.bus_writes = words;
  }
  return access;
}

}  // namespace

MemoryInterface::MemoryInterface(Ram ram, ExternalBus& bus, CycleCounter& counter)
    : ram_(ram), words_(ram.size / 2), bus_(&bus), counter_(&counter) {
  if (ram.size % 2 != 0 || ram.size > k_address_mask + 1) {
    throw std::invalid_argument("the RAM of an MC68000 is an even number of bytes, at most 16 MiB");
  }
}

std::uint8_t MemoryInterface::test_and_set(std::uint32_t address) {
  constexpr std::uint8_t k_set = 0x80;
  const std::uint32_t place = address & k_address_mask;
  if (is_in_ram<OperandSize::byte>(place)) {
    return std::exchange(ram_.bytes[place], static_cast<std::uint8_t>(ram_.bytes[place] | k_set));
  }
  return static_cast<std::uint8_t>(request(Kind::test_and_set, OperandSize::byte, place, k_set));
}

bool MemoryInterface::take_pause() { return std::exchange(pause_, false); }

std::uint32_t MemoryInterface::read_outside(OperandSize size, std::uint32_t place) {
  check_even(size, place);
  if (!is_split(size, place)) {
    return request(Kind::read, size, place, 0);
  }
  const std::uint32_t high = read<OperandSize::word>(place);
  return high << 16U | read<OperandSize::word>(place + 2);
}

void MemoryInterface::write_outside(OperandSize size, std::uint32_t place, std::uint32_t value) {
  check_even(size, place);
  if (is_split(size, place)) {
    write<OperandSize::word>(place, static_cast<std::uint16_t>(value >> 16U));
    write<OperandSize::word>(place + 2, static_cast<std::uint16_t>(value));
  } else {
    request(Kind::write, size, place, value);
  }
}

std::uint16_t MemoryInterface::fetch_beyond(std::uint32_t place) {
  if (is_in_ram<OperandSize::word>(place)) {
    return load<OperandSize::word>(place);
  }
  return static_cast<std::uint16_t>(request(Kind::fetch, OperandSize::word, place, 0));
}

// Whether one word of a long word is in the RAM and the other is not.
bool MemoryInterface::is_split(OperandSize size, std::uint32_t place) const {
  return size == OperandSize::long_word &&
         (place < ram_.size || ((place + 2) & k_address_mask) < ram_.size);
}

std::uint32_t MemoryInterface::request(Kind kind, OperandSize size, std::uint32_t place,
                                       std::uint32_t value) {
  counter_->settle();
  const BusReply reply = bus_->access({kind, size, place, value}, counter_->account());
  counter_->count_outside(counts(kind, size, reply.wait_cycles));
  pause_ = pause_ || reply.pause;
  if (reply.error) {
    throw Fault{StopReason::bus_error, place};
  }
  return reply.value;
}

}  // namespace maquette::models::mc68000
