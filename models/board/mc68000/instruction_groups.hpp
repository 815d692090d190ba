#pragma once

#include "models/board/mc68000/decoder_table.hpp"

namespace maquette::models::mc68000 {

// Each adds a group of instructions to the table, roughly as the tables of the manual group them.
void decode_moves(DecoderTable& table);
void decode_multiple_moves(DecoderTable& table);
void decode_standard_instructions(DecoderTable& table);
void decode_address_arithmetic(DecoderTable& table);
void decode_immediate_instructions(DecoderTable& table);
void decode_single_operands(DecoderTable& table);
void decode_extended_arithmetic(DecoderTable& table);
void decode_multiplications(DecoderTable& table);
void decode_shifts(DecoderTable& table);
void decode_bit_instructions(DecoderTable& table);
void decode_branches(DecoderTable& table);
void decode_jumps(DecoderTable& table);
void decode_status_instructions(DecoderTable& table);
void decode_traps(DecoderTable& table);

/// The bits that name a register in the upper half of an instruction word.
constexpr unsigned k_upper_register = 7U << 9U;

constexpr unsigned upper_register(unsigned word) { return (word >> 9U) & 7U; }

/// The size in bits 6 and 7 of most instructions.
constexpr unsigned size_field(OperandSize size) { return static_cast<unsigned>(size) << 6U; }

/// Gives a meaning to an instruction with an effective address.
inline void set_with_address(DecoderTable& table, unsigned pattern, unsigned free_bits, Mode mode,
                             Handler handler, InstructionCost cost) {
  table.set(pattern | mode_field(mode), free_bits | register_bits(mode), handler, cost);
}

}  // namespace maquette::models::mc68000
