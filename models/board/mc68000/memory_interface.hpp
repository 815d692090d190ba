#pragma once

#include <cstdint>
#include <cstring>

#include "models/board/mc68000/cycle_counter.hpp"
#include "models/board/mc68000/external_bus.hpp"
#include "models/board/mc68000/instruction_cost.hpp"
#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// A RAM from address 0 on, as its bytes lie in it. They stay with the caller.
struct Ram {
  std::uint8_t* bytes = nullptr;
  std::uint32_t size = 0;
};

/// Which of a long word's two words is accessed first.
enum class WordOrder : std::uint8_t { high_first, low_first };

/// How a processor reaches its RAM, and through an external bus all other addresses. Words and long
/// words are big-endian; of addresses 24 bits count.
///
/// Whoever reads or writes data says what the instruction has used `before` the access, since that
/// places it on the bus. Assumption: a fetch falls at the start of its instruction; no program of a
/// board lies off the board.
class MemoryInterface {
 public:
  /// Throws std::invalid_argument for a RAM of an odd number of bytes or of more than 16 MiB.
  MemoryInterface(Ram ram, ExternalBus& bus, CycleCounter& counter);

  /// Throws Fault for an odd address of more than a byte, and when the bus replies an error.
  template <OperandSize size>
  Operand<size> read(std::uint32_t address, PackedCost before,
                     WordOrder order = WordOrder::high_first) {
    const std::uint32_t place = address & k_address_mask;
    if (is_in_ram<size>(place)) {
      return load<size>(place);
    }
    return static_cast<Operand<size>>(read_outside(size, place, before, order));
  }

  /// Throws as read().
  template <OperandSize size>
  void write(std::uint32_t address, Operand<size> value, PackedCost before,
             WordOrder order = WordOrder::high_first) {
    const std::uint32_t place = address & k_address_mask;
    if (is_in_ram<size>(place)) {
      store<size>(place, value);
    } else {
      write_outside(size, place, value, before, order);
    }
  }

  /// Reads a word of the program at an even address. Throws Fault when the bus replies an error.
  std::uint16_t fetch(std::uint32_t address) {
    if (address < ram_.size) {
      return load<OperandSize::word>(address);
    }
    return fetch_beyond(address & k_address_mask);
  }

  /// Reads a byte and sets its highest bit, in one bus cycle. Returns what it was.
  std::uint8_t test_and_set(std::uint32_t address, PackedCost before);

  /// Whether the bus asked for a pause since the last call.
  bool take_pause();

 private:
  static constexpr std::uint32_t k_address_mask = 0xff'ffff;

  // Odd addresses of words, turned by one bit, are beyond every RAM. So one comparison finds both.
  template <OperandSize size>
  [[nodiscard]] bool is_in_ram(std::uint32_t place) const {
    if constexpr (size == OperandSize::byte) {
      return place < ram_.size;
    } else {
      const std::uint32_t turned = (place >> 1U) | (place << 31U);
      return turned + (words_of(size) - 1) < words_;
    }
  }

  template <OperandSize size>
  [[nodiscard]] Operand<size> load(std::uint32_t place) const {
    Operand<size> value;
    std::memcpy(&value, ram_.bytes + place, sizeof value);
    return swapped(value);
  }

  template <OperandSize size>
  void store(std::uint32_t place, Operand<size> value) {
    const Operand<size> stored = swapped(value);
    std::memcpy(ram_.bytes + place, &stored, sizeof stored);
  }

  // Between the host's order of bytes and the processor's.
  static std::uint8_t swapped(std::uint8_t value) { return value; }
  static std::uint16_t swapped(std::uint16_t value) { return __builtin_bswap16(value); }
  static std::uint32_t swapped(std::uint32_t value) { return __builtin_bswap32(value); }
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);

  [[gnu::cold]] std::uint32_t read_outside(OperandSize size, std::uint32_t place, PackedCost before,
                                           WordOrder order);
  std::uint32_t read_words(std::uint32_t place, PackedCost before, WordOrder order);
  [[gnu::cold]] void write_outside(OperandSize size, std::uint32_t place, std::uint32_t value,
                                   PackedCost before, WordOrder order);
  void write_words(std::uint32_t place, std::uint32_t value, PackedCost before, WordOrder order);
  [[gnu::cold]] std::uint16_t fetch_beyond(std::uint32_t place);
  std::uint32_t request(const BusRequest& request);

  Ram ram_;
  std::uint32_t words_;  // of the RAM
  ExternalBus* bus_;
  CycleCounter* counter_;
  bool pause_ = false;
};

}  // namespace maquette::models::mc68000
