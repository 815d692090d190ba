// JMP, JSR, LEA, PEA, RTS, RTR, LINK, UNLK and NOP: tables 8-10 and 8-12 of the manual.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr OperandSize k_long = OperandSize::long_word;

// The manual's times of JMP by its modes; the other instructions differ from it by a constant, or
// count the address in full. Its last access is the fetch of the word behind the one jumped to.
constexpr InstructionCost cost_until_last_fetch(Mode mode) {
  switch (mode) {
    case Mode::indirect:
      return {4, 1};
    case Mode::index:
    case Mode::program_index:
      return {10, 2};
    case Mode::absolute_long:
      return {8, 2};
    default:
      return {6, 1};
  }
}

constexpr InstructionCost jump_cost(Mode mode) { return cost_until_last_fetch(mode) + k_one_word; }

// An indexed address takes two cycles more than as part of an operand.
constexpr InstructionCost load_address_cost(Mode mode) {
  const bool is_indexed = mode == Mode::index || mode == Mode::program_index;
  return k_one_word + address_cost(mode) + InstructionCost{is_indexed ? 2U : 0U};
}

// PEA fetches the next instruction before it pushes, but for absolute addresses.
constexpr InstructionCost cost_until_push(Mode mode) {
  const bool is_absolute = mode == Mode::absolute_short || mode == Mode::absolute_long;
  return is_absolute ? address_cost(mode) : load_address_cost(mode);
}

template <Mode mode>
void jump(ExecutionUnit& unit, unsigned word) {
  unit.enter(address_of<mode, k_long>(unit, word));
}

template <Mode mode>
void jump_to_subroutine(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t target = address_of<mode, k_long>(unit, word);
  unit.push(unit.registers.program_counter, packed(cost_until_last_fetch(mode)));
  unit.enter(target);
}

template <Mode mode>
void load_address(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t address = address_of<mode, k_long>(unit, word);
  unit.registers.address(upper_register(word)) = address;
}

template <Mode mode>
void push_address(ExecutionUnit& unit, unsigned word) {
  unit.push(address_of<mode, k_long>(unit, word), packed(cost_until_push(mode)));
}

void return_from_subroutine(ExecutionUnit& unit, unsigned /*word*/) {
  unit.return_from_subroutine();
}

void return_and_restore(ExecutionUnit& unit, unsigned /*word*/) {
  unit.registers.conditions.set_bits(unit.pop<OperandSize::word>());
  unit.return_from_subroutine(packed(k_one_read));
}

// LINK A7 stores the stack pointer as it is after it was lowered.
void link(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t displacement = sign_extended<OperandSize::word>(unit.fetch());
  std::uint32_t& stack = unit.registers.stack();
  std::uint32_t& frame = unit.registers.address(word);
  stack -= 4;
  unit.memory.write<k_long>(stack, frame, packed(k_one_word));
  frame = stack;
  stack += displacement;
}

void unlink(ExecutionUnit& unit, unsigned word) {
  unit.registers.stack() = unit.registers.address(word);
  const std::uint32_t frame = unit.pop<k_long>();
  unit.registers.address(word) = frame;
}

void no_operation(ExecutionUnit& /*unit*/, unsigned /*word*/) {}

}  // namespace

void decode_jumps(DecoderTable& table) {
  constexpr InstructionCost pushing{8, 0, 0, 2};
  for_each(k_control_modes, [&](auto mode) {
    const InstructionCost target = jump_cost(mode());
    const InstructionCost address = load_address_cost(mode());
    set_with_address(table, 0x4ec0, 0, mode(), jump<mode()>, target);
    set_with_address(table, 0x4e80, 0, mode(), jump_to_subroutine<mode()>, target + pushing);
    set_with_address(table, 0x41c0, k_upper_register, mode(), load_address<mode()>, address);
    set_with_address(table, 0x4840, 0, mode(), push_address<mode()>, address + pushing);
  });
  table.set(0x4e75, 0, return_from_subroutine, {16, 2, 2});
  table.set(0x4e77, 0, return_and_restore, {20, 2, 3});
  table.set(0x4e50, 7, link, {16, 2, 0, 2});
  table.set(0x4e58, 7, unlink, {12, 1, 2});
  table.set(0x4e71, 0, no_operation, k_one_word);
}

}  // namespace maquette::models::mc68000
