#pragma once

#include <cstdint>
#include <type_traits>

namespace maquette::models::mc68000 {

/// What an instruction works on: 8, 16 or 32 bits.
enum class OperandSize : std::uint8_t { byte, word, long_word };

/// An operand of a size, without sign.
template <OperandSize size>
using Operand =
    std::conditional_t<size == OperandSize::byte, std::uint8_t,
                       std::conditional_t<size == OperandSize::word, std::uint16_t, std::uint32_t>>;

/// Bytes of an operand.
constexpr unsigned bytes_of(OperandSize size) { return 1U << static_cast<unsigned>(size); }

/// Bits of an operand.
template <OperandSize size>
constexpr unsigned k_bits = 8 * bytes_of(size);

/// The low part of a register.
template <OperandSize size>
constexpr Operand<size> low_part(std::uint32_t value) {
  return static_cast<Operand<size>>(value);
}

/// A register whose low part is replaced.
template <OperandSize size>
constexpr std::uint32_t with_low_part(std::uint32_t whole, Operand<size> part) {
  if constexpr (size == OperandSize::long_word) {
    return part;
  } else {
    constexpr std::uint32_t mask = (1U << k_bits<size>)-1;
    return (whole & ~mask) | part;
  }
}

/// The operand with its sign carried to 32 bits.
template <OperandSize size>
constexpr std::uint32_t sign_extended(Operand<size> value) {
  return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(static_cast<std::make_signed_t<Operand<size>>>(value)));
}

/// Whether the operand's highest bit is set.
template <OperandSize size>
constexpr bool is_negative(Operand<size> value) {
  return (value >> (k_bits<size> - 1)) != 0;
}

}  // namespace maquette::models::mc68000
