#pragma once

#include "models/board/mc68000/condition_codes.hpp"
#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// The four kinds of shifts, in the order of their code.
enum class ShiftKind : std::uint8_t { arithmetic, logical, rotate_extended, rotate };

/// Shifts by 0 to 63 steps to the left, and sets the condition codes. A count of zero clears C, or
/// copies X to it for the rotation through X.
template <ShiftKind kind, OperandSize size>
Operand<size> shifted_left(ConditionCodes& codes, Operand<size> operand, unsigned count) {
  constexpr unsigned bits = k_bits<size>;
  std::uint64_t result = operand;
  codes.overflow = false;
  codes.carry = false;
  if constexpr (kind == ShiftKind::rotate) {
    const unsigned turn = count % bits;
    result = result << turn | result >> (bits - turn);
    codes.carry = count != 0 && (result & 1U) != 0;
  } else if constexpr (kind == ShiftKind::rotate_extended) {
    const unsigned turn = count % (bits + 1);
    result |= std::uint64_t{codes.extend} << bits;
    if (turn != 0) {
      result = result << turn | result >> (bits + 1 - turn);
    }
    codes.extend = (result >> bits & 1U) != 0;
    codes.carry = codes.extend;
  } else if (count != 0) {
    // Beyond the operand's width all is shifted out; one step more keeps the carry right.
    const unsigned steps = count <= bits ? count : bits + 1;
    if constexpr (kind == ShiftKind::arithmetic) {
      // The sign stays when all bits that pass through it are alike.
      const std::uint64_t lost = result >> (steps < bits ? bits - 1 - steps : 0);
      const std::uint64_t alike = (std::uint64_t{2} << steps) - 1;
      codes.overflow = lost != 0 && (steps >= bits || lost != alike);
    }
    result <<= steps;
    codes.carry = (result >> bits & 1U) != 0;
    codes.extend = codes.carry;
  }
  const auto value = static_cast<Operand<size>>(result);
  codes.set_result<size>(value);
  return value;
}

/// As shifted_left(), to the right.
template <ShiftKind kind, OperandSize size>
Operand<size> shifted_right(ConditionCodes& codes, Operand<size> operand, unsigned count) {
  constexpr unsigned bits = k_bits<size>;
  std::uint64_t result = operand;
  codes.overflow = false;
  codes.carry = false;
  if constexpr (kind == ShiftKind::rotate) {
    const unsigned turn = count % bits;
    result = result >> turn | result << (bits - turn);
    codes.carry = count != 0 && (result >> (bits - 1) & 1U) != 0;
  } else if constexpr (kind == ShiftKind::rotate_extended) {
    const unsigned turn = count % (bits + 1);
    result |= std::uint64_t{codes.extend} << bits;
    if (turn != 0) {
      result = result >> turn | result << (bits + 1 - turn);
    }
    codes.extend = (result >> bits & 1U) != 0;
    codes.carry = codes.extend;
  } else if (count != 0) {
    if constexpr (kind == ShiftKind::arithmetic) {
      result = static_cast<std::uint64_t>(
          static_cast<std::int64_t>(static_cast<std::int32_t>(sign_extended<size>(operand))));
    }
    result = kind == ShiftKind::arithmetic
                 ? static_cast<std::uint64_t>(static_cast<std::int64_t>(result) >> (count - 1))
                 : result >> (count - 1);
    codes.carry = (result & 1U) != 0;
    codes.extend = codes.carry;
    result >>= 1U;
  }
  const auto value = static_cast<Operand<size>>(result);
  codes.set_result<size>(value);
  return value;
}

}  // namespace maquette::models::mc68000
