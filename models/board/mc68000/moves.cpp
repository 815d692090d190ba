// MOVE and MOVEA: tables 8-2 and 8-3 of the manual.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

template <OperandSize size, Mode source, Mode destination>
void move(ExecutionUnit& unit, unsigned word) {
  const Operand<size> value = read_operand<source, size>(unit, word);
  write_operand<destination, size>(unit, upper_register(word), value);
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
