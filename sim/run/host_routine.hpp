#pragma once

#include <cstdint>

#include "models/board/mc68000/execution_unit.hpp"

/// What routines of arithmetic have in common that the host executes for a board.
namespace maquette::sim {

/// Operands and result of a routine, by the registers of the package.
inline constexpr unsigned k_left = 7;
inline constexpr unsigned k_right = 6;

template <class Format>
float number_in(const models::mc68000::ExecutionUnit& unit, unsigned data_register) {
  return Format::value_of(unit.registers.data(data_register));
}

/// Conditions for branches on signed numbers. What is not a number is neither less nor equal.
template <class Format>
void set_comparison(models::mc68000::ExecutionUnit& unit) {
  constexpr unsigned k_conditions = 0xF;
  constexpr unsigned k_negative = 0x8;
  constexpr unsigned k_zero = 0x4;
  const float left = number_in<Format>(unit, k_left);
  const float right = number_in<Format>(unit, k_right);
  unit.registers.set_status((unit.registers.status() & ~k_conditions) |
                            (left < right ? k_negative : 0U) | (left == right ? k_zero : 0U));
}

}  // namespace maquette::sim
