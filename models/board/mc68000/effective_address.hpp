#pragma once

#include <cstdint>

#include "models/board/mc68000/addressing_mode.hpp"
#include "models/board/mc68000/execution_unit.hpp"

namespace maquette::models::mc68000 {

/// How far (An)+ and -(An) move a register: the stack stays even.
template <OperandSize size>
std::uint32_t step_of(unsigned address_register) {
  if (size == OperandSize::byte && address_register == 7) {
    return 2;
  }
  return bytes_of(size);
}

/// Adds displacement and index of an index word to a base. Throws Fault for an index word that an
/// MC68000 would read otherwise than the later processors for which it was written.
inline std::uint32_t indexed(ExecutionUnit& unit, std::uint32_t base) {
  const std::uint32_t word = unit.fetch();
  if ((word & 0x700U) != 0) {
    throw Fault{StopReason::later_encoding};
  }
  const std::uint32_t index = unit.registers.general[word >> 12U];
  const bool whole = (word & 0x800U) != 0;
  return base + sign_extended<OperandSize::byte>(low_part<OperandSize::byte>(word)) +
         (whole ? index : sign_extended<OperandSize::word>(low_part<OperandSize::word>(index)));
}

/// The address of an operand in memory; fetches its extension words and moves (An)+ and -(An).
template <Mode mode, OperandSize size>
std::uint32_t address_of(ExecutionUnit& unit, unsigned field) {
  const unsigned number = field & 7U;
  std::uint32_t& base = unit.registers.address(number);
  const auto displacement = [&unit] { return sign_extended<OperandSize::word>(unit.fetch()); };
  if constexpr (mode == Mode::indirect) {
    return base;
  } else if constexpr (mode == Mode::postincrement) {
    const std::uint32_t address = base;
    base += step_of<size>(number);
    return address;
  } else if constexpr (mode == Mode::predecrement) {
    base -= step_of<size>(number);
    return base;
  } else if constexpr (mode == Mode::displacement) {
    return base + displacement();
  } else if constexpr (mode == Mode::index) {
    return indexed(unit, base);
  } else if constexpr (mode == Mode::absolute_short) {
    return displacement();
  } else if constexpr (mode == Mode::absolute_long) {
    return unit.fetch_long();
  } else {
    static_assert(mode == Mode::program_displacement || mode == Mode::program_index);
    const std::uint32_t here = unit.registers.program_counter;
    if constexpr (mode == Mode::program_index) {
      return indexed(unit, here);
    }
    return here + displacement();
  }
}

/// The operand of an instruction whose low three bits name its register. `before` is what the
/// instruction has used when it begins with the operand's address.
template <Mode mode, OperandSize size>
Operand<size> read_operand(ExecutionUnit& unit, unsigned word, PackedCost before = 0) {
  if constexpr (mode == Mode::data_register) {
    return low_part<size>(unit.registers.data(word));
  } else if constexpr (mode == Mode::address_register) {
    return low_part<size>(unit.registers.address(word));
  } else if constexpr (mode == Mode::immediate) {
    if constexpr (size == OperandSize::long_word) {
      return unit.fetch_long();
    }
    return low_part<size>(unit.fetch());
  } else {
    const std::uint32_t address = address_of<mode, size>(unit, word);
    return unit.memory.read<size>(address, before + packed(address_cost(mode)));
  }
}

/// Replaces the low part of a data register.
template <OperandSize size>
void write_data_register(ExecutionUnit& unit, unsigned number, Operand<size> value) {
  std::uint32_t& whole = unit.registers.data(number);
  whole = with_low_part<size>(whole, value);
}

/// Replaces an operand by what `operation` makes of it. Its address is found once. The next
/// instruction is fetched before the result is written, the low word of a long one first. `before`
/// is what the instruction has used when it begins with the operand's address.
template <Mode mode, OperandSize size, class Operation>
void modify_operand(ExecutionUnit& unit, unsigned field, Operation operation,
                    PackedCost before = 0) {
  if constexpr (mode == Mode::data_register) {
    write_data_register<size>(unit, field, operation(low_part<size>(unit.registers.data(field))));
  } else {
    const std::uint32_t address = address_of<mode, size>(unit, field);
    const PackedCost until_read = before + packed(address_cost(mode));
    const PackedCost until_write = until_read + packed(words_of(size) * k_one_read + k_one_word);
    unit.memory.write<size>(address, operation(unit.memory.read<size>(address, until_read)),
                            until_write, WordOrder::low_first);
  }
}

}  // namespace maquette::models::mc68000
