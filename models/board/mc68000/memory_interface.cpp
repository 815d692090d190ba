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

Account counts(Kind kind, unsigned wait_cycles) {
  Account access;
  access.bus_wait_cycles = wait_cycles;
  access.bus_fetches = kind == Kind::fetch ? 1 : 0;
  access.bus_modifications = kind == Kind::test_and_set ? 1 : 0;
  access.bus_reads = access.bus_modifications + (kind == Kind::read ? 1 : 0);
  access.bus_writes = access.bus_modifications + (kind == Kind::write ? 1 : 0);
  return access;
}

}  // namespace

MemoryInterface::MemoryInterface(Ram ram, ExternalBus& bus, CycleCounter& counter)
    : ram_(ram), words_(ram.size / 2), bus_(&bus), counter_(&counter) {
  if (ram.size % 2 != 0 || ram.size > k_address_mask + 1) {
    throw std::invalid_argument("the RAM of an MC68000 is an even number of bytes, at most 16 MiB");
  }
}

std::uint8_t MemoryInterface::test_and_set(std::uint32_t address, PackedCost before) {
  constexpr std::uint8_t k_set = 0x80;
  const std::uint32_t place = address & k_address_mask;
  if (is_in_ram<OperandSize::byte>(place)) {
    return std::exchange(ram_.bytes[place], static_cast<std::uint8_t>(ram_.bytes[place] | k_set));
  }
  return static_cast<std::uint8_t>(
      request({Kind::test_and_set, OperandSize::byte, place, k_set, unpacked(before)}));
}

bool MemoryInterface::take_pause() { return std::exchange(pause_, false); }

std::uint32_t MemoryInterface::read_outside(OperandSize size, std::uint32_t place,
                                            PackedCost before, WordOrder order) {
  check_even(size, place);
  if (size == OperandSize::long_word) {
    return read_words(place, before, order);
  }
  return request({Kind::read, size, place, 0, unpacked(before)});
}

// One of the words may be in the RAM.
std::uint32_t MemoryInterface::read_words(std::uint32_t place, PackedCost before, WordOrder order) {
  constexpr OperandSize k_word = OperandSize::word;
  if (order == WordOrder::high_first) {
    const std::uint32_t high = read<k_word>(place, before);
    return high << 16U | read<k_word>(place + 2, before + packed(k_one_read));
  }
  const std::uint32_t low = read<k_word>(place + 2, before);
  return low | std::uint32_t{read<k_word>(place, before + packed(k_one_read))} << 16U;
}

void MemoryInterface::write_outside(OperandSize size, std::uint32_t place, std::uint32_t value,
                                    PackedCost before, WordOrder order) {
  check_even(size, place);
  if (size == OperandSize::long_word) {
    write_words(place, value, before, order);
  } else {
    request({Kind::write, size, place, value, unpacked(before)});
  }
}

void MemoryInterface::write_words(std::uint32_t place, std::uint32_t value, PackedCost before,
                                  WordOrder order) {
  constexpr OperandSize k_word = OperandSize::word;
  const auto high = low_part<k_word>(value >> 16U);
  const auto low = low_part<k_word>(value);
  const PackedCost after_one = before + packed(k_one_write);
  if (order == WordOrder::high_first) {
    write<k_word>(place, high, before);
    write<k_word>(place + 2, low, after_one);
  } else {
    write<k_word>(place + 2, low, before);
    write<k_word>(place, high, after_one);
  }
}

std::uint16_t MemoryInterface::fetch_beyond(std::uint32_t place) {
  if (is_in_ram<OperandSize::word>(place)) {
    return load<OperandSize::word>(place);
  }
  return static_cast<std::uint16_t>(request({Kind::fetch, OperandSize::word, place, 0, {}}));
}

std::uint32_t MemoryInterface::request(const BusRequest& request) {
  counter_->settle();
  const BusReply reply = bus_->access(request, counter_->account());
  counter_->count_outside(counts(request.kind, reply.wait_cycles));
  pause_ = pause_ || reply.pause;
  if (reply.error) {
    throw Fault{StopReason::bus_error, request.address};
  }
  return reply.value;
}

}  // namespace maquette::models::mc68000
