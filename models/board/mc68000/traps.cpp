// TRAP, TRAPV, CHK, STOP and RESET: instructions of an MC68000 that a board's firmware never uses
// but in error. CHK and TRAPV go on when there is nothing to report: table 8-9 of the manual.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr OperandSize k_word = OperandSize::word;

[[noreturn]] void trap(ExecutionUnit& /*unit*/, unsigned /*word*/) {
  throw Fault{StopReason::trap};
}

void trap_on_overflow(ExecutionUnit& unit, unsigned /*word*/) {
  if (unit.registers.conditions.overflow) {
    throw Fault{StopReason::overflow_trap};
  }
}

template <Mode mode>
void check_bounds(ExecutionUnit& unit, unsigned word) {
  const auto bound = static_cast<std::int16_t>(read_operand<mode, k_word>(unit, word));
  const auto value = static_cast<std::int16_t>(unit.registers.data(upper_register(word)));
  if (value < 0 || value > bound) {
    throw Fault{StopReason::bounds_check};
  }
}

template <StopReason reason>
[[noreturn]] void stop_supervisor(ExecutionUnit& unit, unsigned /*word*/) {
  unit.require_supervisor();
  throw Fault{reason};
}

}  // namespace

void decode_traps(DecoderTable& table) {
  table.set(0x4e40, 15, trap, {});
  table.set(0x4e76, 0, trap_on_overflow, k_one_word);
  table.set(0x4e72, 0, stop_supervisor<StopReason::stop_instruction>, {});
  table.set(0x4e70, 0, stop_supervisor<StopReason::reset_instruction>, {});
  for_each(k_data_modes, [&](auto mode) {
    set_with_address(table, 0x4180, k_upper_register, mode(), check_bounds<mode()>,
                     InstructionCost{10, 1} + operand_cost(mode(), k_word));
  });
}

}  // namespace maquette::models::mc68000
