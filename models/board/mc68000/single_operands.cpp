// CLR, NEG, NEGX, NOT, TST, TAS, NBCD, SWAP and EXT: table 8-6 of the manual, and parts of 8-12.

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/extended_operations.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

struct Clear {
  static constexpr unsigned k_code = 0x4200;
  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> /*operand*/) {
    codes.set_logical<size>(0);
    return 0;
  }
};

struct Negate {
  static constexpr unsigned k_code = 0x4400;
  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> operand) {
    return Subtract::apply<size>(codes, 0, operand);
  }
};

struct NegateExtended {
  static constexpr unsigned k_code = 0x4000;
  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> operand) {
    return SubtractExtended::apply<size>(codes, 0, operand);
  }
};

struct Not {
  static constexpr unsigned k_code = 0x4600;
  template <OperandSize size>
  static Operand<size> apply(ConditionCodes& codes, Operand<size> operand) {
    const auto result = static_cast<Operand<size>>(~operand);
    codes.set_logical<size>(result);
    return result;
  }
};

// An operand in memory is read even when it is only cleared.
template <class Operation, OperandSize size, Mode mode>
void single_operand(ExecutionUnit& unit, unsigned word) {
  modify_operand<mode, size>(unit, word, [&unit](Operand<size> operand) {
    return Operation::template apply<size>(unit.registers.conditions, operand);
  });
}

template <OperandSize size, Mode mode>
void test(ExecutionUnit& unit, unsigned word) {
  unit.registers.conditions.set_logical<size>(read_operand<mode, size>(unit, word));
}

template <Mode mode>
void test_and_set(ExecutionUnit& unit, unsigned word) {
  std::uint8_t before = 0;
  if constexpr (mode == Mode::data_register) {
    before = low_part<OperandSize::byte>(unit.registers.data(word));
    unit.registers.data(word) |= 0x80U;
  } else {
    before = unit.memory.test_and_set(address_of<mode, OperandSize::byte>(unit, word),
                                      packed(address_cost(mode)));
  }
  unit.registers.conditions.set_logical<OperandSize::byte>(before);
}

template <Mode mode>
void negate_decimal(ExecutionUnit& unit, unsigned word) {
  modify_operand<mode, OperandSize::byte>(unit, word, [&unit](std::uint8_t operand) {
    return SubtractDecimal::apply<OperandSize::byte>(unit.registers.conditions, 0, operand);
  });
}

void swap(ExecutionUnit& unit, unsigned word) {
  std::uint32_t& whole = unit.registers.data(word);
  whole = whole << 16U | whole >> 16U;
  unit.registers.conditions.set_logical<OperandSize::long_word>(whole);
}

void extend_to_word(ExecutionUnit& unit, unsigned word) {
  const auto low = low_part<OperandSize::byte>(unit.registers.data(word));
  const auto value = low_part<OperandSize::word>(sign_extended<OperandSize::byte>(low));
  write_data_register<OperandSize::word>(unit, word, value);
  unit.registers.conditions.set_logical<OperandSize::word>(value);
}

void extend_to_long_word(ExecutionUnit& unit, unsigned word) {
  std::uint32_t& whole = unit.registers.data(word);
  whole = sign_extended<OperandSize::word>(low_part<OperandSize::word>(whole));
  unit.registers.conditions.set_logical<OperandSize::long_word>(whole);
}

constexpr InstructionCost single_cost(OperandSize size, Mode mode) {
  if (mode == Mode::data_register) {
    return {size == OperandSize::long_word ? 6U : 4U, 1};
  }
  return k_one_word + operand_cost(mode, size) + store_cost(size);
}

template <class Operation>
void decode(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_data_alterable_modes, [&](auto mode) {
      set_with_address(table, Operation::k_code | size_field(size()), 0, mode(),
                       single_operand<Operation, size(), mode()>, single_cost(size(), mode()));
    });
  });
}

void decode_test(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_data_alterable_modes, [&](auto mode) {
      set_with_address(table, 0x4a00U | size_field(size()), 0, mode(), test<size(), mode()>,
                       k_one_word + operand_cost(mode(), size()));
    });
  });
}

void decode_bytes(DecoderTable& table) {
  for_each(k_data_alterable_modes, [&](auto mode) {
    const bool in_register = mode() == Mode::data_register;
    const InstructionCost operand = operand_cost(mode(), OperandSize::byte);
    set_with_address(table, 0x4ac0, 0, mode(), test_and_set<mode()>,
                     in_register ? k_one_word : InstructionCost{10, 1, 0, 1} + operand);
    set_with_address(table, 0x4800, 0, mode(), negate_decimal<mode()>,
                     in_register ? InstructionCost{6, 1} : InstructionCost{8, 1, 0, 1} + operand);
  });
}

}  // namespace

void decode_single_operands(DecoderTable& table) {
  decode<Clear>(table);
  decode<Negate>(table);
  decode<NegateExtended>(table);
  decode<Not>(table);
  decode_test(table);
  decode_bytes(table);
  table.set(0x4840, 7, swap, k_one_word);
  table.set(0x4880, 7, extend_to_word, k_one_word);
  table.set(0x48c0, 7, extend_to_long_word, k_one_word);
}

}  // namespace maquette::models::mc68000
