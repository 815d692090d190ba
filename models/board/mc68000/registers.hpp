#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "models/board/mc68000/condition_codes.hpp"

namespace maquette::models::mc68000 {

/// The programmer's model of an MC68000.
struct Registers {
  /// D0 to D7, then A0 to A7, as the index words of addresses number them.
  std::array<std::uint32_t, 16> general{};
  std::uint32_t program_counter = 0;
  /// The stack pointer of the mode that the processor is not in.
  std::uint32_t other_stack = 0;
  ConditionCodes conditions;
  bool supervisor = true;
  std::uint8_t interrupt_mask = 7;

  std::uint32_t& data(unsigned number) { return general[number & 7U]; }
  std::uint32_t& address(unsigned number) { return general[8 + (number & 7U)]; }
  std::uint32_t& stack() { return general[15]; }
  [[nodiscard]] std::uint32_t data(unsigned number) const { return general[number & 7U]; }
  [[nodiscard]] std::uint32_t address(unsigned number) const { return general[8 + (number & 7U)]; }

  /// The status register; the trace bit is never set.
  [[nodiscard]] std::uint16_t status() const {
    return static_cast<std::uint16_t>((supervisor ? 0x2000U : 0U) |
                                      (unsigned{interrupt_mask} << 8U) | conditions.bits());
  }

  /// Sets the status register but for the trace bit; exchanges the stacks when the mode changes.
  void set_status(unsigned status) {
    conditions.set_bits(status);
    interrupt_mask = static_cast<std::uint8_t>((status >> 8U) & 7U);
    const bool to_supervisor = (status & 0x2000U) != 0;
    if (to_supervisor != supervisor) {
      std::swap(stack(), other_stack);
    }
    supervisor = to_supervisor;
  }
};

}  // namespace maquette::models::mc68000
