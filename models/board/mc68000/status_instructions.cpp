// What reads and writes the status register, the condition codes or the user's stack pointer: table
// 8-12 of the manual.

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr OperandSize k_word = OperandSize::word;
constexpr unsigned k_trace_bit = 0x8000;

void set_status(ExecutionUnit& unit, unsigned status) {
  if ((status & k_trace_bit) != 0) {
    throw Fault{StopReason::trace};
  }
  unit.registers.set_status(status);
}

template <Mode mode>
void move_from_status(ExecutionUnit& unit, unsigned word) {
  modify_operand<mode, k_word>(
      unit, word, [&unit](std::uint16_t /*before*/) { return unit.registers.status(); });
}

template <Mode mode>
void move_to_conditions(ExecutionUnit& unit, unsigned word) {
  unit.registers.conditions.set_bits(read_operand<mode, k_word>(unit, word));
}

template <Mode mode>
void move_to_status(ExecutionUnit& unit, unsigned word) {
  unit.require_supervisor();
  set_status(unit, read_operand<mode, k_word>(unit, word));
}

template <class Operation>
void change_conditions(ExecutionUnit& unit, unsigned /*word*/) {
  ConditionCodes unused;
  const std::uint8_t operand = low_part<OperandSize::byte>(unit.fetch());
  unit.registers.conditions.set_bits(Operation::template apply<OperandSize::byte>(
      unused, unit.registers.conditions.bits(), operand));
}

template <class Operation>
void change_status(ExecutionUnit& unit, unsigned /*word*/) {
  unit.require_supervisor();
  ConditionCodes unused;
  const std::uint16_t operand = unit.fetch();
  set_status(unit, Operation::template apply<k_word>(unused, unit.registers.status(), operand));
}

void move_to_user_stack(ExecutionUnit& unit, unsigned word) {
  unit.require_supervisor();
  unit.registers.other_stack = unit.registers.address(word);
}

void move_from_user_stack(ExecutionUnit& unit, unsigned word) {
  unit.require_supervisor();
  unit.registers.address(word) = unit.registers.other_stack;
}

void return_from_exception(ExecutionUnit& unit, unsigned /*word*/) {
  unit.require_supervisor();
  const std::uint16_t status = unit.pop<k_word>();
  unit.return_from_subroutine(packed(k_one_read));
  set_status(unit, status);
}

template <class Operation>
void decode_changes(DecoderTable& table) {
  constexpr InstructionCost cost{20, 3};
  table.set(Operation::k_immediate | 0x3cU, 0, change_conditions<Operation>, cost);
  table.set(Operation::k_immediate | 0x7cU, 0, change_status<Operation>, cost);
}

}  // namespace

void decode_status_instructions(DecoderTable& table) {
  for_each(k_data_alterable_modes, [&](auto mode) {
    const InstructionCost cost = mode() == Mode::data_register
                                     ? InstructionCost{6, 1}
                                     : InstructionCost{8, 1, 0, 1} + operand_cost(mode(), k_word);
    set_with_address(table, 0x40c0, 0, mode(), move_from_status<mode()>, cost);
  });
  for_each(k_data_modes, [&](auto mode) {
    const InstructionCost cost = InstructionCost{12, 1} + operand_cost(mode(), k_word);
    set_with_address(table, 0x44c0, 0, mode(), move_to_conditions<mode()>, cost);
    set_with_address(table, 0x46c0, 0, mode(), move_to_status<mode()>, cost);
  });
  decode_changes<And>(table);
  decode_changes<Or>(table);
  decode_changes<ExclusiveOr>(table);
  table.set(0x4e60, 7, move_to_user_stack, k_one_word);
  table.set(0x4e68, 7, move_from_user_stack, k_one_word);
  table.set(0x4e73, 0, return_from_exception, {20, 2, 3});
}

}  // namespace maquette::models::mc68000
