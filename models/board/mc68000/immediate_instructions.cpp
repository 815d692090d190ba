// ADDI, SUBI, ANDI, ORI, EORI, CMPI, ADDQ, SUBQ and MOVEQ: table 8-5 of the manual.

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

template <class Operation, OperandSize size, Mode mode>
void immediate(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<Mode::immediate, size>(unit, word);
  modify_operand<mode, size>(
      unit, word,
      [&unit, source](Operand<size> destination) {
        return Operation::template apply<size>(unit.registers.conditions, destination, source);
      },
      packed(operand_cost(Mode::immediate, size)));
}

template <OperandSize size, Mode mode>
void compare_immediate(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<Mode::immediate, size>(unit, word);
  const Operand<size> destination =
      read_operand<mode, size>(unit, word, packed(operand_cost(Mode::immediate, size)));
  Compare::apply<size>(unit.registers.conditions, destination, source);
}

// The three bits of a quick operand stand for 1 to 8.
constexpr unsigned quick_operand(unsigned word) { return ((upper_register(word) - 1) & 7U) + 1; }

template <class Operation, OperandSize size, Mode mode>
void quick(ExecutionUnit& unit, unsigned word) {
  const auto source = static_cast<Operand<size>>(quick_operand(word));
  modify_operand<mode, size>(unit, word, [&unit, source](Operand<size> destination) {
    return Operation::template apply<size>(unit.registers.conditions, destination, source);
  });
}

void add_quick_to_address(ExecutionUnit& unit, unsigned word) {
  unit.registers.address(word) += quick_operand(word);
}

void subtract_quick_from_address(ExecutionUnit& unit, unsigned word) {
  unit.registers.address(word) -= quick_operand(word);
}

void move_quick(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t value = sign_extended<OperandSize::byte>(low_part<OperandSize::byte>(word));
  unit.registers.data(upper_register(word)) = value;
  unit.registers.conditions.set_logical<OperandSize::long_word>(value);
}

constexpr InstructionCost immediate_cost(OperandSize size, Mode mode) {
  const InstructionCost own = k_one_word + operand_cost(Mode::immediate, size);
  if (mode == Mode::data_register) {
    return size == OperandSize::long_word ? own + InstructionCost{4} : own;
  }
  return own + operand_cost(mode, size) + store_cost(size);
}

constexpr InstructionCost compare_immediate_cost(OperandSize size, Mode mode) {
  const InstructionCost own = k_one_word + operand_cost(Mode::immediate, size);
  const bool slow = size == OperandSize::long_word && mode == Mode::data_register;
  return own + operand_cost(mode, size) + InstructionCost{slow ? 2U : 0U};
}

constexpr InstructionCost quick_cost(OperandSize size, Mode mode) {
  if (mode == Mode::data_register) {
    return {size == OperandSize::long_word ? 8U : 4U, 1};
  }
  return k_one_word + operand_cost(mode, size) + store_cost(size);
}

template <class Operation>
void decode_immediate(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_data_alterable_modes, [&](auto mode) {
      set_with_address(table, Operation::k_immediate | size_field(size()), 0, mode(),
                       immediate<Operation, size(), mode()>, immediate_cost(size(), mode()));
    });
  });
}

void decode_compare_immediate(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_data_alterable_modes, [&](auto mode) {
      set_with_address(table, Compare::k_immediate | size_field(size()), 0, mode(),
                       compare_immediate<size(), mode()>, compare_immediate_cost(size(), mode()));
    });
  });
}

template <class Operation>
void decode_quick(DecoderTable& table, unsigned pattern, Handler on_address) {
  for_each_size([&](auto size) {
    for_each(k_data_alterable_modes, [&](auto mode) {
      set_with_address(table, pattern | size_field(size()), k_upper_register, mode(),
                       quick<Operation, size(), mode()>, quick_cost(size(), mode()));
    });
    if constexpr (size() != OperandSize::byte) {
      set_with_address(table, pattern | size_field(size()), k_upper_register,
                       Mode::address_register, on_address, {8, 1});
    }
  });
}

}  // namespace

void decode_immediate_instructions(DecoderTable& table) {
  decode_immediate<Add>(table);
  decode_immediate<Subtract>(table);
  decode_immediate<And>(table);
  decode_immediate<Or>(table);
  decode_immediate<ExclusiveOr>(table);
  decode_compare_immediate(table);
  decode_quick<Add>(table, 0x5000, add_quick_to_address);
  decode_quick<Subtract>(table, 0x5100, subtract_quick_from_address);
  table.set(0x7000, k_upper_register | 0xffU, move_quick, k_one_word);
}

}  // namespace maquette::models::mc68000
