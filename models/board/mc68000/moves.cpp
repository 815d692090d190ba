// MOVE and MOVEA: tables 8-2 and 8-3 of the manual.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

// What is used before the destination is written. With -(An) the next instruction is fetched before
// it; with an absolute long address what follows its upper word is fetched after it, when the
// source was in memory.
constexpr InstructionCost cost_until_write(OperandSize size, Mode source, Mode destination) {
  const InstructionCost until_source = operand_cost(source, size);
  if (destination == Mode::predecrement) {
    return until_source + k_one_word;
  }
  if (destination == Mode::absolute_long && !is_register_or_immediate(source)) {
    return until_source + k_one_word;
  }
  return until_source + address_cost(destination);
}

template <OperandSize size, Mode source, Mode destination>
void move(ExecutionUnit& unit, unsigned word) {
  const Operand<size> value = read_operand<source, size>(unit, word);
  const unsigned field = upper_register(word);
  if constexpr (destination == Mode::data_register) {
    write_data_register<size>(unit, field, value);
  } else {
    constexpr bool downwards = destination == Mode::predecrement;
    unit.memory.write<size>(address_of<destination, size>(unit, field), value,
                            packed(cost_until_write(size, source, destination)),
                            downwards ? WordOrder::low_first : WordOrder::high_first);
  }
  unit.registers.conditions.set_logical<size>(value);
}

template <OperandSize size, Mode source>
void move_address(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t value = sign_extended<size>(read_operand<source, size>(unit, word));
  unit.registers.address(upper_register(word)) = value;
}

// A predecremented destination takes no time of its own: the read before it hides it.
constexpr InstructionCost destination_cost(OperandSize size, Mode mode) {
  if (is_register_or_immediate(mode)) {
    return {};
  }
  if (mode == Mode::predecrement) {
    return store_cost(size);
  }
  return address_cost(mode) + store_cost(size);
}

constexpr unsigned size_code(OperandSize size) {
  switch (size) {
    case OperandSize::byte:
      return 0x1000;
    case OperandSize::word:
      return 0x3000;
    default:
      return 0x2000;
  }
}

// The destination has its register above its mode.
constexpr unsigned upper_mode_field(Mode mode) {
  const unsigned field = mode_field(mode);
  return (field >> 3U) << 6U | (field & 7U) << 9U;
}

template <OperandSize size, Mode source>
void decode_from(DecoderTable& table) {
  constexpr InstructionCost own = k_one_word + operand_cost(source, size);
  for_each(k_data_alterable_modes, [&](auto destination) {
    set_with_address(table, size_code(size) | upper_mode_field(destination()),
                     register_bits(destination()) << 9U, source, move<size, source, destination()>,
                     own + destination_cost(size, destination()));
  });
  if constexpr (size != OperandSize::byte) {
    set_with_address(table, size_code(size) | upper_mode_field(Mode::address_register),
                     k_upper_register, source, move_address<size, source>, own);
  }
}

}  // namespace

void decode_moves(DecoderTable& table) {
  for_each_size([&](auto size) {
    for_each(k_all_modes, [&](auto source) {
      if constexpr (source() != Mode::address_register || size() != OperandSize::byte) {
        decode_from<size(), source()>(table);
      }
    });
  });
}

}  // namespace maquette::models::mc68000
