#pragma once

#include <cstdint>

#include "models/board/mc68000/multiplication_time.hpp"

namespace maquette::models {

/// What a routine of the arithmetic package takes from its first instruction to its return, as
/// `PackageCall` measures it.
struct RoutineCost {
  unsigned cycles = 0;
  unsigned reads = 0;
  unsigned writes = 0;
};

constexpr RoutineCost operator+(RoutineCost a, RoutineCost b) {
  return {a.cycles + b.cycles, a.reads + b.reads, a.writes + b.writes};
}
constexpr RoutineCost& operator+=(RoutineCost& a, RoutineCost b) { return a = a + b; }

/// The parts that paths through the routines are put together of (MC68000 User's Manual, section
/// 8).
namespace routine_cost {

/// Instructions of one word on registers, in byte or word size, MOVE and MOVEQ in any.
constexpr RoutineCost words(unsigned count) { return {4 * count, count, 0}; }

inline constexpr RoutineCost k_taken{10, 2, 0};  // Bcc, BRA; DBcc that goes on
inline constexpr RoutineCost k_not_taken{8, 1, 0};
inline constexpr RoutineCost k_word_not_taken{12, 2, 0};  // with a displacement of a word
inline constexpr RoutineCost k_loop_left{12, 2, 0};       // DBcc with its condition true
inline constexpr RoutineCost k_loop_expired{14, 3, 0};    // DBcc with its counter run out
inline constexpr RoutineCost k_call{18, 2, 2};            // BSR
inline constexpr RoutineCost k_return{16, 4, 0};
inline constexpr RoutineCost k_long{8, 1, 0};                // ADD.L, SUB.L on registers
inline constexpr RoutineCost k_long_compare{6, 1, 0};        // CMP.L on registers; NEG.L as well
inline constexpr RoutineCost k_immediate{8, 2, 0};           // a byte or word and a register
inline constexpr RoutineCost k_long_add{16, 3, 0};           // ADDI.L
inline constexpr RoutineCost k_long_compare_with{14, 3, 0};  // CMPI.L
inline constexpr RoutineCost k_bit_test{10, 2, 0};           // BTST
inline constexpr RoutineCost k_low_bit_clear{12, 2, 0};      // BCLR below bit 16
inline constexpr RoutineCost k_low_bit_set{10, 2, 0};        // BSET below bit 16
inline constexpr RoutineCost k_high_bit_set{12, 2, 0};

constexpr RoutineCost branch(bool taken) { return taken ? k_taken : k_not_taken; }
constexpr RoutineCost word_branch(bool taken) { return taken ? k_taken : k_word_not_taken; }
constexpr RoutineCost shift(unsigned places) { return {6 + 2 * places, 1, 0}; }
constexpr RoutineCost long_shift(unsigned places) { return {8 + 2 * places, 1, 0}; }

inline RoutineCost multiplication(std::uint32_t source) {
  return {38 + mc68000::unsigned_multiplication_cycles(static_cast<std::uint16_t>(source)), 1, 0};
}
inline RoutineCost signed_multiplication(std::uint32_t source) {
  return {38 + mc68000::signed_multiplication_cycles(static_cast<std::uint16_t>(source)), 1, 0};
}
inline RoutineCost division(std::uint32_t dividend, std::uint32_t divisor) {
  return {mc68000::unsigned_division_cycles(dividend, static_cast<std::uint16_t>(divisor)), 1, 0};
}

/// A number's parts.
constexpr std::uint32_t mantissa(std::uint32_t number) { return number & 0xffffff00U; }
constexpr std::uint32_t high(std::uint32_t number) { return number >> 16U; }
constexpr std::uint32_t low(std::uint32_t number) { return number & 0xff00U; }
constexpr std::uint32_t exponent(std::uint32_t number) { return number & 0x7fU; }
constexpr bool negative(std::uint32_t number) { return (number & 0x80U) != 0; }

/// Returns the largest number of a sign.
constexpr RoutineCost largest(bool is_negative) {
  return is_negative ? words(1) + k_return : words(1) + k_low_bit_clear + k_return;
}

/// Returns it where two branches find that an exponent has run over; where it has not, goes on.
constexpr RoutineCost overflow_branches(bool overflow, bool is_negative) {
  if (!overflow) {
    return k_not_taken + k_not_taken;
  }
  return is_negative ? k_not_taken + k_taken : k_taken;
}

}  // namespace routine_cost

/// Costs of the routines on their operands, for those that are zero or normalised.
RoutineCost add_cost(std::uint32_t d7, std::uint32_t d6);
RoutineCost subtract_cost(std::uint32_t d7, std::uint32_t d6);
RoutineCost multiply_cost(std::uint32_t d7, std::uint32_t d6);
RoutineCost divide_cost(std::uint32_t d7, std::uint32_t d6);
RoutineCost square_root_cost(std::uint32_t d7);
RoutineCost compare_cost(std::uint32_t d7, std::uint32_t d6);
RoutineCost negate_cost(std::uint32_t d7);
RoutineCost absolute_cost();
RoutineCost test_cost(std::uint32_t d7);
RoutineCost from_integer_cost(std::uint32_t integer);
RoutineCost to_integer_cost(std::uint32_t d7);

}  // namespace maquette::models
