// BTST, BCHG, BCLR and BSET: table 8-8 of the manual. Its times for registers are maxima: two
// cycles less for a bit of the lower word, but for BTST.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

enum class BitAction : std::uint8_t { test, change, clear, set };

template <BitAction action>
std::uint32_t acted(std::uint32_t operand, std::uint32_t bit) {
  if constexpr (action == BitAction::change) {
    return operand ^ bit;
  }
  if constexpr (action == BitAction::clear) {
    return operand & ~bit;
  }
  if constexpr (action == BitAction::set) {
    return operand | bit;
  }
  return operand;
}

// `before` is what the instruction has used when it begins with the operand's address.
template <BitAction action, Mode mode>
void act_on_bit(ExecutionUnit& unit, unsigned word, unsigned number, PackedCost before) {
  ConditionCodes& conditions = unit.registers.conditions;
  if constexpr (mode == Mode::data_register) {
    const std::uint32_t bit = 1U << (number & 31U);
    std::uint32_t& operand = unit.registers.data(word);
    conditions.non_zero = operand & bit;
    operand = acted<action>(operand, bit);
    if constexpr (action != BitAction::test) {
      if ((number & 16U) != 0) {
        unit.counter.charge_cycles(2);
      }
    }
  } else {
    const std::uint32_t bit = 1U << (number & 7U);
    if constexpr (action == BitAction::test) {
      conditions.non_zero = read_operand<mode, OperandSize::byte>(unit, word, before) & bit;
    } else {
      modify_operand<mode, OperandSize::byte>(
          unit, word,
          [&](std::uint8_t operand) {
            conditions.non_zero = operand & bit;
            return low_part<OperandSize::byte>(acted<action>(operand, bit));
          },
          before);
    }
  }
}

template <BitAction action, Mode mode>
void by_register(ExecutionUnit& unit, unsigned word) {
  act_on_bit<action, mode>(unit, word, unit.registers.data(upper_register(word)), 0);
}

template <BitAction action, Mode mode>
void by_immediate(ExecutionUnit& unit, unsigned word) {
  const unsigned number = unit.fetch();
  act_on_bit<action, mode>(unit, word, number, packed(k_one_word));
}

template <BitAction action>
constexpr InstructionCost bit_cost(Mode mode) {
  const InstructionCost operand = operand_cost(mode, OperandSize::byte);
  if (action == BitAction::test) {
    return InstructionCost{is_register_or_immediate(mode) ? 6U : 4U, 1} + operand;
  }
  if (mode == Mode::data_register) {
    return {action == BitAction::clear ? 8U : 6U, 1};
  }
  return InstructionCost{8, 1, 0, 1} + operand;
}

template <BitAction action, Mode mode>
void decode_mode(DecoderTable& table) {
  constexpr unsigned code = static_cast<unsigned>(action) << 6U;
  constexpr InstructionCost cost = bit_cost<action>(mode);
  set_with_address(table, 0x0100U | code, k_upper_register, mode, by_register<action, mode>, cost);
  if constexpr (mode != Mode::immediate) {
    set_with_address(table, 0x0800U | code, 0, mode, by_immediate<action, mode>,
                     cost + InstructionCost{4, 1});
  }
}

template <BitAction action, class Modes>
void decode(DecoderTable& table, Modes modes) {
  for_each(modes, [&](auto mode) { decode_mode<action, mode()>(table); });
}

}  // namespace

void decode_bit_instructions(DecoderTable& table) {
  decode<BitAction::test>(table, k_data_modes);
  decode<BitAction::change>(table, k_data_alterable_modes);
  decode<BitAction::clear>(table, k_data_alterable_modes);
  decode<BitAction::set>(table, k_data_alterable_modes);
}

}  // namespace maquette::models::mc68000
