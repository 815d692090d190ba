#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "models/board/mc68000/execution_unit.hpp"
#include "models/board/mc68000/instruction_cost.hpp"

namespace maquette::models::mc68000 {

/// Executes one instruction, whose first word is given and was fetched. Throws Fault.
using Handler = void (*)(ExecutionUnit& unit, unsigned word);

/// An instruction word: who executes it, and its cost but for what depends on operands.
struct DecodedInstruction {
  Handler execute;
  PackedCost cost;
};

/// What each of the 65,536 instruction words means.
class DecoderTable {
 public:
  /// All words are illegal, or of line A or F.
  DecoderTable();

  /// Gives a meaning to `pattern` and to all words that differ from it in `free_bits` only. Throws
  /// std::logic_error when one of them has a meaning.
  void set(unsigned pattern, unsigned free_bits, Handler handler, InstructionCost cost);

  [[nodiscard]] const DecodedInstruction& operator[](std::uint16_t word) const {
    return instructions_[word];
  }

  /// Whether an MC68000 has this instruction.
  [[nodiscard]] bool is_legal(std::uint16_t word) const;

 private:
  std::array<DecodedInstruction, 0x10000> instructions_;
};

/// The table of the MC68000.
const DecoderTable& decoder_table();

}  // namespace maquette::models::mc68000
