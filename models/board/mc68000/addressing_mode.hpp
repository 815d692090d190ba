#pragma once

#include <cstdint>
#include <type_traits>

#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// The addressing modes, in the order of their code: the mode field, and for 7 the register field.
enum class AddressingMode : std::uint8_t {
  data_register,
  address_register,
  indirect,
  postincrement,
  predecrement,
  displacement,
  index,
  absolute_short,
  absolute_long,
  program_displacement,
  program_index,
  immediate,
};

using Mode = AddressingMode;

/// Whether the mode's register field names a register.
constexpr bool has_register(Mode mode) { return mode <= Mode::index; }

/// Whether the operand is in the instruction or in a register.
constexpr bool is_register_or_immediate(Mode mode) {
  return mode <= Mode::address_register || mode == Mode::immediate;
}

/// The six bits of an effective address, its register left zero where there is one.
constexpr unsigned mode_field(Mode mode) {
  const auto code = static_cast<unsigned>(mode);
  return has_register(mode) ? code << 3U : (7U << 3U) | (code - 7U);
}

/// The bits of an effective address that are free to name a register.
constexpr unsigned register_bits(Mode mode) { return has_register(mode) ? 7U : 0U; }

/// Modes as types, so that handlers are made for each of them.
template <Mode... modes>
struct ModeList {};

/// Calls `body` with each mode as a constant.
template <class Body, Mode... modes>
void for_each(ModeList<modes...> /*list*/, Body body) {
  (body(std::integral_constant<Mode, modes>{}), ...);
}

/// Calls `body` with each size as a constant.
template <class Body>
void for_each_size(Body body) {
  body(std::integral_constant<OperandSize, OperandSize::byte>{});
  body(std::integral_constant<OperandSize, OperandSize::word>{});
  body(std::integral_constant<OperandSize, OperandSize::long_word>{});
}

// Motorola's categories of addressing modes.
constexpr ModeList<Mode::data_register, Mode::address_register, Mode::indirect, Mode::postincrement,
                   Mode::predecrement, Mode::displacement, Mode::index, Mode::absolute_short,
                   Mode::absolute_long, Mode::program_displacement, Mode::program_index,
                   Mode::immediate>
    k_all_modes;
constexpr ModeList<Mode::data_register, Mode::indirect, Mode::postincrement, Mode::predecrement,
                   Mode::displacement, Mode::index, Mode::absolute_short, Mode::absolute_long,
                   Mode::program_displacement, Mode::program_index, Mode::immediate>
    k_data_modes;
constexpr ModeList<Mode::indirect, Mode::postincrement, Mode::predecrement, Mode::displacement,
                   Mode::index, Mode::absolute_short, Mode::absolute_long>
    k_memory_alterable_modes;
constexpr ModeList<Mode::data_register, Mode::indirect, Mode::postincrement, Mode::predecrement,
                   Mode::displacement, Mode::index, Mode::absolute_short, Mode::absolute_long>
    k_data_alterable_modes;
constexpr ModeList<Mode::indirect, Mode::displacement, Mode::index, Mode::absolute_short,
                   Mode::absolute_long, Mode::program_displacement, Mode::program_index>
    k_control_modes;

}  // namespace maquette::models::mc68000
