// ADDA, SUBA and CMPA: table 8-4 of the manual. Words are sign-extended, and all 32 bits are worked
// on.

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

template <OperandSize size, Mode mode>
std::uint32_t extended_operand(ExecutionUnit& unit, unsigned word) {
  return sign_extended<size>(read_operand<mode, size>(unit, word));
}

template <OperandSize size, Mode mode>
void add_address(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t source = extended_operand<size, mode>(unit, word);
  unit.registers.address(upper_register(word)) += source;
}

template <OperandSize size, Mode mode>
void subtract_address(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t source = extended_operand<size, mode>(unit, word);
  unit.registers.address(upper_register(word)) -= source;
}

template <OperandSize size, Mode mode>
void compare_address(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t source = extended_operand<size, mode>(unit, word);
  const std::uint32_t destination = unit.registers.address(upper_register(word));
  Compare::apply<OperandSize::long_word>(unit.registers.conditions, destination, source);
}

template <OperandSize size>
void decode(DecoderTable& table) {
  constexpr bool is_long = size == OperandSize::long_word;
  constexpr unsigned code = is_long ? 0x1c0 : 0x0c0;
  for_each(k_all_modes, [&](auto mode) {
    const InstructionCost operand = operand_cost(mode(), size);
    const bool fast = is_long && !is_register_or_immediate(mode());
    const InstructionCost sum = InstructionCost{fast ? 6U : 8U, 1} + operand;
    const InstructionCost comparison = InstructionCost{6, 1} + operand;
    set_with_address(table, Add::k_line | code, k_upper_register, mode(), add_address<size, mode()>,
                     sum);
    set_with_address(table, Subtract::k_line | code, k_upper_register, mode(),
                     subtract_address<size, mode()>, sum);
    set_with_address(table, Compare::k_line | code, k_upper_register, mode(),
                     compare_address<size, mode()>, comparison);
  });
}

}  // namespace

void decode_address_arithmetic(DecoderTable& table) {
  decode<OperandSize::word>(table);
  decode<OperandSize::long_word>(table);
}

}  // namespace maquette::models::mc68000
