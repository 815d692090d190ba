// MULU, MULS, DIVU and DIVS: table 8-4 of the manual, and what they cost by their operands.

#include "models/board/mc68000/effective_address.hpp"
#include "models/board/mc68000/instruction_groups.hpp"
#include "models/board/mc68000/multiplication_time.hpp"

namespace maquette::models::mc68000 {

namespace {

constexpr OperandSize k_word = OperandSize::word;

void store_product(ExecutionUnit& unit, unsigned number, std::uint32_t product) {
  unit.registers.data(number) = product;
  unit.registers.conditions.set_logical<OperandSize::long_word>(product);
}

template <Mode mode>
void multiply_unsigned(ExecutionUnit& unit, unsigned word) {
  const std::uint16_t source = read_operand<mode, k_word>(unit, word);
  const unsigned number = upper_register(word);
  unit.counter.charge_cycles(unsigned_multiplication_cycles(source));
  store_product(unit, number,
                std::uint32_t{source} * low_part<k_word>(unit.registers.data(number)));
}

template <Mode mode>
void multiply_signed(ExecutionUnit& unit, unsigned word) {
  const std::uint16_t source = read_operand<mode, k_word>(unit, word);
  const unsigned number = upper_register(word);
  unit.counter.charge_cycles(signed_multiplication_cycles(source));
  const std::uint16_t other = low_part<k_word>(unit.registers.data(number));
  store_product(unit, number, sign_extended<k_word>(source) * sign_extended<k_word>(other));
}

// A quotient that does not fit leaves the register as it is; the manual leaves N and Z undefined
// then, and here they stay.
void store_quotient(ExecutionUnit& unit, unsigned number, bool fits, std::uint32_t quotient,
                    std::uint32_t remainder) {
  ConditionCodes& conditions = unit.registers.conditions;
  if (fits) {
    conditions.set_result<k_word>(low_part<k_word>(quotient));
    unit.registers.data(number) = remainder << 16U | low_part<k_word>(quotient);
  }
  conditions.overflow = !fits;
  conditions.carry = false;
}

template <Mode mode>
void divide_unsigned(ExecutionUnit& unit, unsigned word) {
  const std::uint16_t divisor = read_operand<mode, k_word>(unit, word);
  if (divisor == 0) {
    throw Fault{StopReason::divide_by_zero};
  }
  const unsigned number = upper_register(word);
  const std::uint32_t dividend = unit.registers.data(number);
  const std::uint32_t quotient = dividend / divisor;
  unit.counter.charge_cycles(unsigned_division_cycles(dividend, divisor));
  store_quotient(unit, number, quotient <= 0xffff, quotient, dividend % divisor);
}

template <Mode mode>
void divide_signed(ExecutionUnit& unit, unsigned word) {
  const auto divisor = static_cast<std::int16_t>(read_operand<mode, k_word>(unit, word));
  if (divisor == 0) {
    throw Fault{StopReason::divide_by_zero};
  }
  const unsigned number = upper_register(word);
  const auto dividend = static_cast<std::int32_t>(unit.registers.data(number));
  const std::int64_t quotient = std::int64_t{dividend} / divisor;
  const std::int64_t remainder = std::int64_t{dividend} % divisor;
  unit.counter.charge_cycles(signed_division_cycles(dividend, divisor));
  store_quotient(unit, number, quotient >= INT16_MIN && quotient <= INT16_MAX,
                 static_cast<std::uint32_t>(quotient), static_cast<std::uint32_t>(remainder));
}

}  // namespace

void decode_multiplications(DecoderTable& table) {
  for_each(k_data_modes, [&](auto mode) {
    const InstructionCost operand = operand_cost(mode(), k_word);
    const InstructionCost multiplication = InstructionCost{38, 1} + operand;
    const InstructionCost division = InstructionCost{0, 1} + operand;
    set_with_address(table, 0xc0c0, k_upper_register, mode(), multiply_unsigned<mode()>,
                     multiplication);
    set_with_address(table, 0xc1c0, k_upper_register, mode(), multiply_signed<mode()>,
                     multiplication);
    set_with_address(table, 0x80c0, k_upper_register, mode(), divide_unsigned<mode()>, division);
    set_with_address(table, 0x81c0, k_upper_register, mode(), divide_signed<mode()>, division);
  });
}

}  // namespace maquette::models::mc68000
