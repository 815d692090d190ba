#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "models/board/mc68000/mc68000.hpp"

namespace maquette::tests {

using models::mc68000::Account;
using models::mc68000::ExternalBus;
using models::mc68000::Mc68000;
using models::mc68000::NoExternalBus;
using models::mc68000::Registers;
using models::mc68000::Stop;
using models::mc68000::StopReason;

/// A processor with 64 KiB of RAM and nothing else; programs begin at 0x1000.
class SmallBoard {
 public:
  static constexpr std::uint32_t k_size = 0x10000;
  static constexpr std::uint32_t k_program = 0x1000;

  SmallBoard() : memory_(k_size), processor_({memory_.data(), k_size}, bus_) {
    registers().stack() = 0x8000;
  }

  Mc68000& processor() { return processor_; }
  Registers& registers() { return processor_.registers(); }
  std::uint32_t& d(unsigned number) { return registers().data(number); }
  std::uint32_t& a(unsigned number) { return registers().address(number); }

  /// X N Z V C as bits 4 to 0.
  unsigned codes() { return registers().conditions.bits(); }
  void set_codes(unsigned bits) { registers().conditions.set_bits(bits); }

  void load(std::initializer_list<unsigned> words, std::uint32_t address = k_program) {
    for (const unsigned word : words) {
      poke(address, 2, word);
      address += 2;
    }
    registers().program_counter = k_program;
  }

  /// Executes one instruction.
  Stop execute(std::initializer_list<unsigned> words) {
    load(words);
    return processor_.step();
  }

  void poke(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    for (unsigned byte = bytes; byte-- != 0; value >>= 8U) {
      memory_.at(address + byte) = static_cast<std::uint8_t>(value);
    }
  }

  std::uint32_t peek(std::uint32_t address, unsigned bytes) const {
    std::uint32_t value = 0;
    for (unsigned byte = 0; byte < bytes; ++byte) value = value << 8U | memory_.at(address + byte);
    return value;
  }

 private:
  std::vector<std::uint8_t> memory_;
  NoExternalBus bus_;
  Mc68000 processor_;
};

}  // namespace maquette::tests
