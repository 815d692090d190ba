#pragma once

#include <cstdint>

#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// The condition codes, kept as they fall out of an operation and composed only when they are read.
struct ConditionCodes {
  std::uint32_t sign = 0;      // N is its highest bit
  std::uint32_t non_zero = 1;  // Z is set when this is zero
  bool overflow = false;
  bool carry = false;
  bool extend = false;

  [[nodiscard]] bool negative() const { return (sign >> 31U) != 0; }
  [[nodiscard]] bool zero() const { return non_zero == 0; }

  /// N and Z of a result.
  template <OperandSize size>
  void set_result(Operand<size> result) {
    sign = sign_extended<size>(result);
    non_zero = result;
  }

  /// N and Z of a result; V and C are cleared, as moves and logic do.
  template <OperandSize size>
  void set_logical(Operand<size> result) {
    set_result<size>(result);
    overflow = false;
    carry = false;
  }

  /// XNZVC, as the low byte of the status register has them.
  [[nodiscard]] std::uint8_t bits() const {
    return static_cast<std::uint8_t>((extend ? 16U : 0U) | (negative() ? 8U : 0U) |
                                     (zero() ? 4U : 0U) | (overflow ? 2U : 0U) | (carry ? 1U : 0U));
  }

  void set_bits(unsigned bits) {
    extend = (bits & 16U) != 0;
    sign = (bits & 8U) << 28U;
    non_zero = ~bits & 4U;
    overflow = (bits & 2U) != 0;
    carry = (bits & 1U) != 0;
  }
};

/// Whether the condition of this code, that of Bcc, DBcc and Scc, holds.
template <unsigned condition>
bool holds(const ConditionCodes& codes) {
  static_assert(condition < 16);
  constexpr bool inverted = (condition & 1U) != 0;
  constexpr unsigned kind = condition >> 1U;
  bool truth = true;
  if constexpr (kind == 1) {
    truth = !codes.carry && !codes.zero();
  }
  if constexpr (kind == 2) {
    truth = !codes.carry;
  }
  if constexpr (kind == 3) {
    truth = !codes.zero();
  }
  if constexpr (kind == 4) {
    truth = !codes.overflow;
  }
  if constexpr (kind == 5) {
    truth = !codes.negative();
  }
  if constexpr (kind == 6) {
    truth = codes.negative() == codes.overflow;
  }
  if constexpr (kind == 7) {
    truth = !codes.zero() && codes.negative() == codes.overflow;
  }
  return truth != inverted;
}

}  // namespace maquette::models::mc68000
