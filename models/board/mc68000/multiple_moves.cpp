// MOVEM and MOVEP: tables 8-10 and 8-12 of the manual.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr unsigned k_registers = 16;

template <OperandSize size>
void charge_registers(ExecutionUnit& unit, unsigned count, InstructionCost words) {
  unit.counter.charge(count * packed({4 * words_of(size), 0, words_of(size) * words.reads,
                                      words_of(size) * words.writes}));
}

// What is used before the first register is moved: the mask is fetched, and the address found.
constexpr InstructionCost cost_until_first(Mode mode) { return k_one_word + address_cost(mode); }

// In the mask of a predecremented destination A7 comes first. A register that is its own base is
// stored as it was before.
template <OperandSize size>
void store_downwards(ExecutionUnit& unit, unsigned word) {
  const unsigned mask = unit.fetch();
  std::uint32_t address = unit.registers.address(word);
  unsigned count = 0;
  for (unsigned bit = 0; bit < k_registers; ++bit) {
    if ((mask >> bit & 1U) == 0) {
      continue;
    }
    address -= bytes_of(size);
    unit.memory.write<size>(address, low_part<size>(unit.registers.general[k_registers - 1 - bit]),
                            packed(k_one_word) + count * packed(store_cost(size)),
                            WordOrder::low_first);
    ++count;
  }
  unit.registers.address(word) = address;
  charge_registers<size>(unit, count, {0, 0, 0, 1});
}

template <OperandSize size, Mode mode>
void store_registers(ExecutionUnit& unit, unsigned word) {
  const unsigned mask = unit.fetch();
  std::uint32_t address = address_of<mode, size>(unit, word);
  unsigned count = 0;
  for (unsigned number = 0; number < k_registers; ++number) {
    if ((mask >> number & 1U) == 0) {
      continue;
    }
    unit.memory.write<size>(address, low_part<size>(unit.registers.general[number]),
                            packed(cost_until_first(mode)) + count * packed(store_cost(size)));
    address += bytes_of(size);
    ++count;
  }
  charge_registers<size>(unit, count, {0, 0, 0, 1});
}

// The processor reads one word beyond the last register, and drops it.
template <OperandSize size, Mode mode>
void load_registers(ExecutionUnit& unit, unsigned word) {
  constexpr Mode start = mode == Mode::postincrement ? Mode::indirect : mode;
  constexpr PackedCost load = packed(words_of(size) * k_one_read);
  const unsigned mask = unit.fetch();
  std::uint32_t address = address_of<start, size>(unit, word);
  unsigned count = 0;
  for (unsigned number = 0; number < k_registers; ++number) {
    if ((mask >> number & 1U) == 0) {
      continue;
    }
    unit.registers.general[number] = sign_extended<size>(
        unit.memory.read<size>(address, packed(cost_until_first(mode)) + count * load));
    address += bytes_of(size);
    ++count;
  }
  unit.memory.read<OperandSize::word>(address, packed(cost_until_first(mode)) + count * load);
  if constexpr (mode == Mode::postincrement) {
    unit.registers.address(word) = address;
  }
  charge_registers<size>(unit, count, {0, 0, 1, 0});
}

// MOVEP: every second byte, the highest first.
template <OperandSize size>
void store_peripheral(ExecutionUnit& unit, unsigned word) {
  std::uint32_t address = address_of<Mode::displacement, size>(unit, word);
  const std::uint32_t value = unit.registers.data(upper_register(word));
  for (unsigned byte = 0; byte < bytes_of(size); ++byte) {
    const unsigned shift = k_bits<size> - 8 * (byte + 1);
    unit.memory.write<OperandSize::byte>(address, low_part<OperandSize::byte>(value >> shift),
                                         packed(k_one_word) + byte * packed(k_one_write));
    address += 2;
  }
}

template <OperandSize size>
void load_peripheral(ExecutionUnit& unit, unsigned word) {
  std::uint32_t address = address_of<Mode::displacement, size>(unit, word);
  std::uint32_t value = 0;
  for (unsigned byte = 0; byte < bytes_of(size); ++byte) {
    value = value << 8U | unit.memory.read<OperandSize::byte>(
                              address, packed(k_one_word) + byte * packed(k_one_read));
    address += 2;
  }
  write_data_register<size>(unit, upper_register(word), low_part<size>(value));
}

template <OperandSize size>
void decode_multiple(DecoderTable& table) {
  constexpr unsigned code = size == OperandSize::long_word ? 0x0040 : 0;
  constexpr unsigned store = 0x4880 | code;
  constexpr unsigned load = 0x4c80 | code;
  constexpr InstructionCost storing{8, 2};
  constexpr InstructionCost loading{12, 2, 1};
  for_each(k_control_modes, [&](auto mode) {
    const InstructionCost address = address_cost(mode());
    if constexpr (mode() < Mode::program_displacement) {
      set_with_address(table, store, 0, mode(), store_registers<size, mode()>, storing + address);
    }
    set_with_address(table, load, 0, mode(), load_registers<size, mode()>, loading + address);
  });
  set_with_address(table, store, 0, Mode::predecrement, store_downwards<size>, storing);
  set_with_address(table, load, 0, Mode::postincrement, load_registers<size, Mode::postincrement>,
                   loading);
}

}  // namespace

void decode_multiple_moves(DecoderTable& table) {
  decode_multiple<OperandSize::word>(table);
  decode_multiple<OperandSize::long_word>(table);
  constexpr unsigned registers = k_upper_register | 7U;
  table.set(0x0108, registers, load_peripheral<OperandSize::word>, {16, 2, 2});
  table.set(0x0148, registers, load_peripheral<OperandSize::long_word>, {24, 2, 4});
  table.set(0x0188, registers, store_peripheral<OperandSize::word>, {16, 2, 0, 2});
  table.set(0x01c8, registers, store_peripheral<OperandSize::long_word>, {24, 2, 0, 4});
}

}  // namespace maquette::models::mc68000
