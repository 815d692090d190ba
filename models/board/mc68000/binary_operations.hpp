#pragma once

#include "models/board/mc68000/condition_codes.hpp"
#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// The operations of two operands: what `destination` becomes, and the condition codes. `k_line` is
/// the upper half-byte of the instruction between a register and an operand, `k_immediate` the
/// instruction with an immediate operand.
struct Add {
  static constexpr unsigned k_line = 0xd000;
  static constexpr unsigned k_immediate = 0x0600;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const auto sum = static_cast<Operand<size>>(destination + source);
    codes.carry = sum < source;
    codes.extend = codes.carry;
    codes.overflow =
        is_negative<size>(static_cast<Operand<size>>((sum ^ source) & (sum ^ destination)));
    codes.set_result<size>(sum);
    return sum;
  }
};

/// The difference, and all condition codes but X.
struct Compare {
  static constexpr unsigned k_line = 0xb000;
  static constexpr unsigned k_immediate = 0x0c00;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const auto difference = static_cast<Operand<size>>(destination - source);
    codes.carry = source > destination;
    codes.overflow = is_negative<size>(
        static_cast<Operand<size>>((destination ^ source) & (destination ^ difference)));
    codes.set_result<size>(difference);
    return difference;
  }
};

struct Subtract {
  static constexpr unsigned k_line = 0x9000;
  static constexpr unsigned k_immediate = 0x0400;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const Operand<size> difference = Compare::apply<size>(codes, destination, source);
    codes.extend = codes.carry;
    return difference;
  }
};

struct And {
  static constexpr unsigned k_line = 0xc000;
  static constexpr unsigned k_immediate = 0x0200;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const auto result = static_cast<Operand<size>>(destination & source);
    codes.set_logical<size>(result);
    return result;
  }
};

struct Or {
  static constexpr unsigned k_line = 0x8000;
  static constexpr unsigned k_immediate = 0x0000;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const auto result = static_cast<Operand<size>>(destination | source);
    codes.set_logical<size>(result);
    return result;
  }
};

struct ExclusiveOr {
  static constexpr unsigned k_line = 0xb000;
  static constexpr unsigned k_immediate = 0x0a00;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const auto result = static_cast<Operand<size>>(destination ^ source);
    codes.set_logical<size>(result);
    return result;
  }
};

}  // namespace maquette::models::mc68000
