#include "models/board/mc68000/decoder_table.hpp"

#include <stdexcept>

#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

template <StopReason reason>
[[noreturn]] void refuse(ExecutionUnit& /*unit*/, unsigned /*word*/) {
  throw Fault{reason};
}

Handler refusal_of(unsigned word) {
  if (word >> 12U == 0xa) {
    return refuse<StopReason::line_a>;
  }
  if (word >> 12U == 0xf) {
    return refuse<StopReason::line_f>;
  }
  return refuse<StopReason::illegal_instruction>;
}

DecoderTable make_table() {
  DecoderTable table;
  decode_moves(table);
  decode_multiple_moves(table);
  decode_standard_instructions(table);
  decode_address_arithmetic(table);
  decode_immediate_instructions(table);
  decode_single_operands(table);
  decode_extended_arithmetic(table);
  decode_multiplications(table);
  decode_shifts(table);
  decode_bit_instructions(table);
  decode_branches(table);
  decode_jumps(table);
  decode_status_instructions(table);
  decode_traps(table);
  return table;
}

}  // namespace

DecoderTable::DecoderTable() {
  for (unsigned word = 0; word < instructions_.size(); ++word) {
    instructions_[word] = {refusal_of(word), 0};
  }
}

void DecoderTable::set(unsigned pattern, unsigned free_bits, Handler handler,
                       InstructionCost cost) {
  unsigned variant = free_bits;
  while (true) {
    const unsigned word = (pattern & ~free_bits) | variant;
    if (is_legal(static_cast<std::uint16_t>(word))) {
      throw std::logic_error("an instruction word has two meanings");
    }
    instructions_[word] = {handler, packed(cost)};
    if (variant == 0) {
      return;
    }
    variant = (variant - 1) & free_bits;
  }
}

bool DecoderTable::is_legal(std::uint16_t word) const {
  return instructions_[word].execute != refusal_of(word);
}

const DecoderTable& decoder_table() {
  static const DecoderTable table = make_table();
  return table;
}

}  // namespace maquette::models::mc68000
