// ADD, SUB, AND, OR, EOR and CMP between a data register and an operand: table 8-4 of the manual.

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

template <class Operation, OperandSize size, Mode mode>
void to_register(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<mode, size>(unit, word);
  const unsigned number = upper_register(word);
  const auto destination = low_part<size>(unit.registers.data(number));
  const auto result =
      Operation::template apply<size>(unit.registers.conditions, destination, source);
  write_data_register<size>(unit, number, result);
}

template <OperandSize size, Mode mode>
void compare_register(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<mode, size>(unit, word);
  const auto destination = low_part<size>(unit.registers.data(upper_register(word)));
  Compare::apply<size>(unit.registers.conditions, destination, source);
}

template <class Operation, OperandSize size, Mode mode>
void to_operand(ExecutionUnit& unit, unsigned word) {
  const auto source = low_part<size>(unit.registers.data(upper_register(word)));
  modify_operand<mode, size>(unit, word, [&unit, source](Operand<size> destination) {
    return Operation::template apply<size>(unit.registers.conditions, destination, source);
  });
}

constexpr InstructionCost to_register_cost(OperandSize size, Mode mode) {
  if (size != OperandSize::long_word) {
    return k_one_word + operand_cost(mode, size);
  }
  const InstructionCost own{is_register_or_immediate(mode) ? 8U : 6U, 1};
  return own + operand_cost(mode, size);
}

constexpr InstructionCost compare_cost(OperandSize size, Mode mode) {
  const InstructionCost own{size == OperandSize::long_word ? 6U : 4U, 1};
  return own + operand_cost(mode, size);
}

constexpr InstructionCost to_operand_cost(OperandSize size, Mode mode) {
  if (mode == Mode::data_register) {
    return {size == OperandSize::long_word ? 8U : 4U, 1};
  }
  return k_one_word + operand_cost(mode, size) + store_cost(size);
}

template <class Operation, class Modes>
void decode_to_register(DecoderTable& table, Modes modes) {
  for_each_size([&](auto size) {
    for_each(modes, [&](auto mode) {
      if constexpr (mode() != Mode::address_register || size() != OperandSize::byte) {
        set_with_address(table, Operation::k_line | size_field(size()), k_upper_register, mode(),
                         to_register<Operation, size(), mode()>, to_register_cost(size(), mode()));
      }
    });
  });
}

void decode_compare(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_all_modes, [&](auto mode) {
      if constexpr (mode() != Mode::address_register || size() != OperandSize::byte) {
        set_with_address(table, Compare::k_line | size_field(size()), k_upper_register, mode(),
                         compare_register<size(), mode()>, compare_cost(size(), mode()));
      }
    });
  });
}

template <class Operation, class Modes>
void decode_to_operand(DecoderTable& table, Modes modes) {
  for_each_size([&](auto size) {
    for_each(modes, [&](auto mode) {
      set_with_address(table, Operation::k_line | 0x100U | size_field(size()), k_upper_register,
                       mode(), to_operand<Operation, size(), mode()>,
                       to_operand_cost(size(), mode()));
    });
  });
}

}  // namespace

void decode_standard_instructions(DecoderTable& table) {
  decode_to_register<Add>(table, k_all_modes);
  decode_to_register<Subtract>(table, k_all_modes);
  decode_to_register<And>(table, k_data_modes);
  decode_to_register<Or>(table, k_data_modes);
  decode_compare(table);
  decode_to_operand<Add>(table, k_memory_alterable_modes);
  decode_to_operand<Subtract>(table, k_memory_alterable_modes);
  decode_to_operand<And>(table, k_memory_alterable_modes);
  decode_to_operand<Or>(table, k_memory_alterable_modes);
  decode_to_operand<ExclusiveOr>(table, k_data_alterable_modes);
}

}  // namespace maquette::models::mc68000
