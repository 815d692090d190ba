// Bcc, BRA, BSR, DBcc and Scc: tables 8-6 and 8-9 of the manual.

#include <utility>

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr unsigned k_byte_mask = 0xff;

std::uint32_t byte_displacement(unsigned word) {
  return sign_extended<OperandSize::byte>(low_part<OperandSize::byte>(word));
}

std::uint32_t word_displacement(ExecutionUnit& unit) {
  return sign_extended<OperandSize::word>(unit.fetch());
}

// Where a branch goes. A displacement of zero is in the next word; both count from there.
template <bool in_word>
std::uint32_t branch_target(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t here = unit.registers.program_counter;
  return here + (in_word ? word_displacement(unit) : byte_displacement(word));
}

template <unsigned condition, bool in_word>
void branch_if(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t target = branch_target<in_word>(unit, word);
  if (holds<condition>(unit.registers.conditions)) {
    unit.jump(target);
    unit.counter.charge(packed(in_word ? InstructionCost{2} : InstructionCost{6, 1}));
  } else {
    unit.counter.charge_cycles(4);
  }
}

template <bool in_word>
void branch(ExecutionUnit& unit, unsigned word) {
  unit.enter(branch_target<in_word>(unit, word));
}

template <bool in_word>
void branch_to_subroutine(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t target = branch_target<in_word>(unit, word);
  unit.push(unit.registers.program_counter, packed_cycles(2));
  unit.enter(target);
}

// The later processors take a displacement of 0xff for one of 32 bits; here it would be odd.
[[noreturn]] void branch_far(ExecutionUnit& /*unit*/, unsigned /*word*/) {
  throw Fault{StopReason::later_encoding};
}

// The word at the target is fetched before the counter is looked at.
template <unsigned condition>
void decrement_and_branch(ExecutionUnit& unit, unsigned word) {
  const std::uint32_t target = branch_target<true>(unit, word);
  if (holds<condition>(unit.registers.conditions)) {
    unit.counter.charge_cycles(2);
    return;
  }
  ExecutionUnit::check_target(target);
  const auto counter = static_cast<std::uint16_t>(unit.registers.data(word) - 1);
  write_data_register<OperandSize::word>(unit, word, counter);
  if (counter != 0xffff) {
    unit.registers.program_counter = target;
  } else {
    unit.counter.charge(packed({4, 1}));
  }
}

template <unsigned condition, Mode mode>
void set_if(ExecutionUnit& unit, unsigned word) {
  const bool truth = holds<condition>(unit.registers.conditions);
  modify_operand<mode, OperandSize::byte>(
      unit, word, [truth](std::uint8_t /*before*/) -> std::uint8_t { return truth ? 0xff : 0; });
  if (mode == Mode::data_register && truth) {
    unit.counter.charge_cycles(2);
  }
}

// Branches with a word of displacement, those with a byte, and those of later processors.
void set_branch(DecoderTable& table, unsigned pattern, Handler in_word, Handler in_byte,
                InstructionCost word_cost, InstructionCost byte_cost) {
  table.set(pattern, 0, in_word, word_cost);
  for (unsigned displacement = 1; displacement < k_byte_mask; ++displacement) {
    table.set(pattern | displacement, 0, in_byte, byte_cost);
  }
  table.set(pattern | k_byte_mask, 0, branch_far, byte_cost);
}

template <unsigned condition>
void decode_condition(DecoderTable& table) {
  constexpr unsigned code = condition << 8U;
  if constexpr (condition >= 2) {
    set_branch(table, 0x6000U | code, branch_if<condition, true>, branch_if<condition, false>,
               {8, 2}, {4, 1});
  }
  table.set(0x50c8U | code, 7, decrement_and_branch<condition>, {10, 2});
  for_each(k_data_alterable_modes, [&](auto mode) {
    const InstructionCost cost =
        mode() == Mode::data_register
            ? k_one_word
            : InstructionCost{8, 1, 0, 1} + operand_cost(mode(), OperandSize::byte);
    set_with_address(table, 0x50c0U | code, 0, mode(), set_if<condition, mode()>, cost);
  });
}

template <unsigned... conditions>
void decode_conditions(DecoderTable& table,
                       std::integer_sequence<unsigned, conditions...> /*sequence*/) {
  (decode_condition<conditions>(table), ...);
}

}  // namespace

void decode_branches(DecoderTable& table) {
  decode_conditions(table, std::make_integer_sequence<unsigned, 16>{});
  set_branch(table, 0x6000, branch<true>, branch<false>, {10, 2}, {10, 2});
  set_branch(table, 0x6100, branch_to_subroutine<true>, branch_to_subroutine<false>, {18, 2, 0, 2},
             {18, 2, 0, 2});
}

}  // namespace maquette::models::mc68000
