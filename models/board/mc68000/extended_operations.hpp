#pragma once

#include "models/board/mc68000/condition_codes.hpp"
#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// The operations on numbers of several words: X is carried in, and Z is only ever cleared.
struct AddExtended {
  static constexpr unsigned k_code = 0xd100;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const std::uint64_t wide = std::uint64_t{destination} + source + (codes.extend ? 1U : 0U);
    const auto sum = static_cast<Operand<size>>(wide);
    codes.extend = wide >> k_bits<size> != 0;
    codes.carry = codes.extend;
    codes.overflow =
        is_negative<size>(static_cast<Operand<size>>((sum ^ source) & (sum ^ destination)));
    codes.sign = sign_extended<size>(sum);
    codes.non_zero |= sum;
    return sum;
  }
};

struct SubtractExtended {
  static constexpr unsigned k_code = 0x9100;

  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> destination,
                             Operand<size> source) {
    const std::uint64_t wide = std::uint64_t{destination} - source - (codes.extend ? 1U : 0U);
    const auto difference = static_cast<Operand<size>>(wide);
    codes.extend = wide >> 63U != 0;
    codes.carry = codes.extend;
    codes.overflow = is_negative<size>(
        static_cast<Operand<size>>((destination ^ source) & (destination ^ difference)));
    codes.sign = sign_extended<size>(difference);
    codes.non_zero |= difference;
    return difference;
  }
};

/// Two decimal digits. The manual leaves N and V undefined, and all for digits beyond nine; here
/// the sum is the binary one, to which 6 is added for each digit beyond nine, N is the result's
/// highest bit, and V says whether that correction has set it.
struct AddDecimal {
  static constexpr unsigned k_code = 0xc100;

  template <OperandSize size>
  static std::uint8_t apply(ConditionCodes& codes, std::uint8_t destination, std::uint8_t source) {
    const unsigned extend = codes.extend ? 1 : 0;
    const unsigned binary = unsigned{destination} + source + extend;
    unsigned sum = binary;
    if ((destination & 15U) + (source & 15U) + extend > 9) {
      sum += 0x06;
    }
    if (sum > 0x9f) {
      sum += 0x60;
    }
    codes.extend = sum > 0xff;
    codes.carry = codes.extend;
    codes.overflow = (~binary & sum & 0x80U) != 0;
    codes.sign = sum << 24U;
    codes.non_zero |= sum & 0xffU;
    return static_cast<std::uint8_t>(sum);
  }
};

/// As AddDecimal: the difference is the binary one, from which 6 is taken for each digit that
/// borrows.
struct SubtractDecimal {
  static constexpr unsigned k_code = 0x8100;

  template <OperandSize size>
  static std::uint8_t apply(ConditionCodes& codes, std::uint8_t destination, std::uint8_t source) {
    const unsigned extend = codes.extend ? 1 : 0;
    const unsigned binary = unsigned{destination} - source - extend;
    unsigned difference = binary;
    if ((destination & 15U) < (source & 15U) + extend) {
      difference -= 0x06;
    }
    if (destination < source + extend) {
      difference -= 0x60;
    }
    codes.extend = difference > 0xff;
    codes.carry = codes.extend;
    codes.overflow = (binary & ~difference & 0x80U) != 0;
    codes.sign = difference << 24U;
    codes.non_zero |= difference & 0xffU;
    return static_cast<std::uint8_t>(difference);
  }
};

}  // namespace maquette::models::mc68000
