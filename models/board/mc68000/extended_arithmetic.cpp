// ADDX, SUBX, ABCD, SBCD, CMPM and EXG: table 8-11 of the manual, and EXG of 8-12.

#include <utility>

#include "models/board/mc68000/binary_operations.hpp"
#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/extended_operations.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr unsigned k_two_registers = k_upper_register | 7U;

template <class Operation, OperandSize size>
void in_registers(ExecutionUnit& unit, unsigned word) {
  const unsigned number = upper_register(word);
  const auto source = low_part<size>(unit.registers.data(word));
  const auto destination = low_part<size>(unit.registers.data(number));
  write_data_register<size>(
      unit, number,
      Operation::template apply<size>(unit.registers.conditions, destination, source));
}

template <class Operation, OperandSize size>
void in_memory(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<Mode::predecrement, size>(unit, word);
  modify_operand<Mode::predecrement, size>(
      unit, upper_register(word),
      [&unit, source](Operand<size> destination) {
        return Operation::template apply<size>(unit.registers.conditions, destination, source);
      },
      packed(k_one_read));
}

// Downwards the low word is first, and the next instruction is fetched between the two writes.
template <class Operation>
void in_memory_long(ExecutionUnit& unit, unsigned word) {
  constexpr OperandSize k_long = OperandSize::long_word;
  constexpr PackedCost until_source = packed(address_cost(Mode::predecrement));
  constexpr PackedCost until_destination = until_source + 2 * packed(k_one_read);
  constexpr PackedCost until_low = until_destination + 2 * packed(k_one_read);
  MemoryInterface& memory = unit.memory;
  const auto read = [&](unsigned field, PackedCost before) {
    return memory.read<k_long>(address_of<Mode::predecrement, k_long>(unit, field), before,
                               WordOrder::low_first);
  };
  const std::uint32_t source = read(word, until_source);
  const std::uint32_t destination = read(upper_register(word), until_destination);
  const std::uint32_t result =
      Operation::template apply<k_long>(unit.registers.conditions, destination, source);
  const std::uint32_t address = unit.registers.address(upper_register(word));
  memory.write<OperandSize::word>(address + 2, low_part<OperandSize::word>(result), until_low);
  memory.write<OperandSize::word>(address, low_part<OperandSize::word>(result >> 16U),
                                  until_low + packed(k_one_write + k_one_word));
}

template <OperandSize size>
void compare_memory(ExecutionUnit& unit, unsigned word) {
  const Operand<size> source = read_operand<Mode::postincrement, size>(unit, word);
  const Operand<size> destination = read_operand<Mode::postincrement, size>(
      unit, upper_register(word), packed(words_of(size) * k_one_read));
  Compare::apply<size>(unit.registers.conditions, destination, source);
}

template <unsigned upper_base, unsigned lower_base>
void exchange(ExecutionUnit& unit, unsigned word) {
  std::swap(unit.registers.general[upper_base + upper_register(word)],
            unit.registers.general[lower_base + (word & 7U)]);
}

template <class Operation>
void decode_binary(DecoderTable& table) {
  for_each_size([&](auto size) {
    const bool is_long = size() == OperandSize::long_word;
    const unsigned code = Operation::k_code | size_field(size());
    table.set(code, k_two_registers, in_registers<Operation, size()>,
              is_long ? InstructionCost{8, 1} : k_one_word);
    if constexpr (size() == OperandSize::long_word) {
      table.set(code | 8U, k_two_registers, in_memory_long<Operation>, {30, 1, 4, 2});
    } else {
      table.set(code | 8U, k_two_registers, in_memory<Operation, size()>, {18, 1, 2, 1});
    }
  });
}

template <class Operation>
void decode_decimal(DecoderTable& table) {
  constexpr OperandSize k_byte = OperandSize::byte;
  table.set(Operation::k_code, k_two_registers, in_registers<Operation, k_byte>, {6, 1});
  table.set(Operation::k_code | 8U, k_two_registers, in_memory<Operation, k_byte>, {18, 1, 2, 1});
}

}  // namespace

void decode_extended_arithmetic(DecoderTable& table) {
  decode_binary<AddExtended>(table);
  decode_binary<SubtractExtended>(table);
  decode_decimal<AddDecimal>(table);
  decode_decimal<SubtractDecimal>(table);
  for_each_size([&](auto size) {
    const bool is_long = size() == OperandSize::long_word;
    table.set(0xb108U | size_field(size()), k_two_registers, compare_memory<size()>,
              is_long ? InstructionCost{20, 1, 4} : InstructionCost{12, 1, 2});
  });
  table.set(0xc140, k_two_registers, exchange<0, 0>, {6, 1});
  table.set(0xc148, k_two_registers, exchange<8, 8>, {6, 1});
  table.set(0xc188, k_two_registers, exchange<0, 8>, {6, 1});
}

}  // namespace maquette::models::mc68000
