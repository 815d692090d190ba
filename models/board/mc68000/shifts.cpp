// ASL, ASR, LSL, LSR, ROXL, ROXR, ROL and ROR: table 8-7 of the manual.

#include "models/board/mc68000/shift_operations.hpp"

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr unsigned k_left = 0x100;

template <ShiftKind kind, bool left, OperandSize size>
Operand<size> shifted(ConditionCodes& codes, Operand<size> operand, unsigned count) {
  if constexpr (left) {
    return shifted_left<kind, size>(codes, operand, count);
  }
  return shifted_right<kind, size>(codes, operand, count);
}

template <ShiftKind kind, bool left, OperandSize size>
void shift_register(ExecutionUnit& unit, unsigned number, unsigned count) {
  const auto operand = low_part<size>(unit.registers.data(number));
  unit.counter.charge_cycles(2 * count);
  write_data_register<size>(unit, number,
                            shifted<kind, left, size>(unit.registers.conditions, operand, count));
}

template <ShiftKind kind, bool left, OperandSize size>
void by_immediate(ExecutionUnit& unit, unsigned word) {
  const unsigned count = ((upper_register(word) - 1) & 7U) + 1;
  shift_register<kind, left, size>(unit, word, count);
}

template <ShiftKind kind, bool left, OperandSize size>
void by_register(ExecutionUnit& unit, unsigned word) {
  const unsigned count = unit.registers.data(upper_register(word)) & 63U;
  shift_register<kind, left, size>(unit, word, count);
}

template <ShiftKind kind, bool left, Mode mode>
void shift_memory(ExecutionUnit& unit, unsigned word) {
  modify_operand<mode, OperandSize::word>(unit, word, [&unit](std::uint16_t operand) {
    return shifted<kind, left, OperandSize::word>(unit.registers.conditions, operand, 1);
  });
}

template <ShiftKind kind, bool left>
void decode(DecoderTable& table) {
  constexpr auto kind_code = static_cast<unsigned>(kind);
  constexpr unsigned code = 0xe000U | (left ? k_left : 0U);
  for_each_size([&](auto size) {
    const unsigned pattern = code | size_field(size()) | kind_code << 3U;
    const InstructionCost cost{size() == OperandSize::long_word ? 8U : 6U, 1};
    table.set(pattern, k_upper_register | 7U, by_immediate<kind, left, size()>, cost);
    table.set(pattern | 0x20U, k_upper_register | 7U, by_register<kind, left, size()>, cost);
  });
  for_each(k_memory_alterable_modes, [&](auto mode) {
    set_with_address(table, code | 0xc0U | kind_code << 9U, 0, mode(),
                     shift_memory<kind, left, mode()>,
                     InstructionCost{8, 1, 0, 1} + operand_cost(mode(), OperandSize::word));
  });
}

template <ShiftKind kind>
void decode_both(DecoderTable& table) {
  decode<kind, false>(table);
  decode<kind, true>(table);
}

}  // namespace

void decode_shifts(DecoderTable& table) {
  decode_both<ShiftKind::arithmetic>(table);
  decode_both<ShiftKind::logical>(table);
  decode_both<ShiftKind::rotate_extended>(table);
  decode_both<ShiftKind::rotate>(table);
}

}  // namespace maquette::models::mc68000
