#pragma once

#include <cstdint>

#include "models/board/mc68000/addressing_mode.hpp"

namespace maquette::models::mc68000 {

/// Clock cycles without wait states and 16-bit bus accesses, as the tables of the MC68000 User's
/// Manual (section 8) count them. Their reads are program fetches (prefetched words that are never
/// executed included) and reads of data.
struct InstructionCost {
  unsigned cycles = 0;
  unsigned fetches = 0;
  unsigned reads = 0;
  unsigned writes = 0;
};

constexpr InstructionCost operator+(InstructionCost a, InstructionCost b) {
  return {a.cycles + b.cycles, a.fetches + b.fetches, a.reads + b.reads, a.writes + b.writes};
}

constexpr InstructionCost operator*(unsigned count, InstructionCost cost) {
  return {count * cost.cycles, count * cost.fetches, count * cost.reads, count * cost.writes};
}

/// A cost in 64 bits, cycles on top, so that one addition charges it and one comparison sees
/// whether a limit of cycles is reached. An access takes four cycles, so that no part overflows
/// before the cycles do.
using PackedCost = std::uint64_t;

/// Most cycles that a packed cost holds.
constexpr unsigned k_most_packed_cycles = 0xffff;

constexpr PackedCost packed_cycles(unsigned cycles) { return PackedCost{cycles} << 48U; }

constexpr PackedCost packed(InstructionCost cost) {
  return packed_cycles(cost.cycles) | (PackedCost{cost.fetches} << 32U) |
         (PackedCost{cost.reads} << 16U) | PackedCost{cost.writes};
}

constexpr InstructionCost unpacked(PackedCost cost) {
  const auto part = [cost](unsigned shift) {
    return static_cast<unsigned>(cost >> shift) & 0xffffU;
  };
  return {part(48), part(32), part(16), part(0)};
}

/// Bus accesses of an operand.
constexpr unsigned words_of(OperandSize size) { return size == OperandSize::long_word ? 2 : 1; }

/// What the address of an operand costs: its extension words and its arithmetic.
constexpr InstructionCost address_cost(Mode mode) {
  switch (mode) {
    case Mode::predecrement:
      return {2};
    case Mode::displacement:
    case Mode::absolute_short:
    case Mode::program_displacement:
      return {4, 1};
    case Mode::index:
    case Mode::program_index:
      return {6, 1};
    case Mode::absolute_long:
      return {8, 2};
    default:
      return {};
  }
}

/// Table 8-1: what an operand costs to fetch, its address included.
constexpr InstructionCost operand_cost(Mode mode, OperandSize size) {
  const unsigned words = words_of(size);
  if (mode == Mode::immediate) {
    return {4 * words, words};
  }
  if (is_register_or_immediate(mode)) {
    return {};
  }
  return address_cost(mode) + InstructionCost{4 * words, 0, words};
}

/// An access of data.
constexpr InstructionCost k_one_read{4, 0, 1};
constexpr InstructionCost k_one_write{4, 0, 0, 1};

/// What storing an operand costs.
constexpr InstructionCost store_cost(OperandSize size) { return words_of(size) * k_one_write; }

/// An instruction of one word that does nothing but fetch the next.
constexpr InstructionCost k_one_word{4, 1};

}  // namespace maquette::models::mc68000
