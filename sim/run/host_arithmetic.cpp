#include "sim/run/host_arithmetic.hpp"

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/maquette_ffp/format.hpp"
#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "firmware/arithmetic/real.hpp"

namespace maquette::sim {

namespace {

using firmware::Operation;
using firmware::maquette_ffp::from_ffp;
using firmware::maquette_ffp::to_ffp;
using models::mc68000::ExecutionUnit;
using models::mc68000::NativeCalls;

/// Operands and result of a routine, by the registers of the package.
constexpr unsigned k_left = 7;
constexpr unsigned k_right = 6;

float number_in(const ExecutionUnit& unit, unsigned data_register) {
  return from_ffp(unit.registers.data(data_register));
}

/// A routine of two operands; with a zero operand, or a zero result of a product, it is another
/// operation to the cost tables.
template <class Compute>
auto binary(Operation operation, Operation with_zero, firmware::Work& work, Compute compute) {
  return [operation, with_zero, &work, compute](ExecutionUnit& unit) {
    const float left = number_in(unit, k_left);
    const float right = number_in(unit, k_right);
    const std::uint32_t result = to_ffp(compute(left, right));
    const bool zero = left == 0 || (right == 0 && operation != Operation::divide) ||
                      (result == 0 && operation == Operation::multiply);
    ++work[zero ? with_zero : operation];
    unit.registers.data(k_left) = result;
    unit.return_from_subroutine();
  };
}

template <class Compute>
auto unary(Operation operation, firmware::Work& work, Compute compute) {
  return [operation, &work, compute](ExecutionUnit& unit) {
    ++work[operation];
    unit.registers.data(k_left) = compute(unit.registers.data(k_left));
    unit.return_from_subroutine();
  };
}

void compare(ExecutionUnit& unit) {
  constexpr unsigned k_conditions = 0xF;
  constexpr unsigned k_negative = 0x8;
  constexpr unsigned k_zero = 0x4;
  const float left = number_in(unit, k_left);
  const float right = number_in(unit, k_right);
  unit.registers.set_status((unit.registers.status() & ~k_conditions) |
                            (left < right ? k_negative : 0U) | (left == right ? k_zero : 0U));
  unit.return_from_subroutine();
}

void add_package(std::uint32_t package, NativeCalls& routines, firmware::Work& work) {
  namespace ffp = firmware::maquette_ffp;
  routines.add(package + ffp::k_add_entry, binary(Operation::add, Operation::add_zero, work,
                                                  [](float a, float b) { return a + b; }));
  routines.add(package + ffp::k_subtract_entry,
               binary(Operation::subtract, Operation::subtract_zero, work,
                      [](float a, float b) { return a - b; }));
  routines.add(package + ffp::k_multiply_entry,
               binary(Operation::multiply, Operation::multiply_zero, work,
                      [](float a, float b) { return a * b; }));
  routines.add(package + ffp::k_divide_entry, binary(Operation::divide, Operation::divide_zero,
                                                     work, [](float a, float b) { return a / b; }));
  routines.add(package + ffp::k_square_root_entry,
               unary(Operation::square_root, work, [](std::uint32_t bits) {
                 return to_ffp(firmware::square_root(from_ffp(bits)));
               }));
  routines.add(package + ffp::k_to_integer_entry,
               unary(Operation::float_to_integer, work, [](std::uint32_t bits) {
                 return static_cast<std::uint32_t>(firmware::to_integer(from_ffp(bits)));
               }));
  routines.add(package + ffp::k_from_integer_entry,
               unary(Operation::integer_to_float, work, [](std::uint32_t bits) {
                 return to_ffp(static_cast<float>(static_cast<std::int32_t>(bits)));
               }));
  routines.add(package + ffp::k_compare_entry, [&work](ExecutionUnit& unit) {
    ++work[Operation::compare];
    compare(unit);
  });
}

/// Where the firmware's elementary functions are in a board's RAM; 0 where a scene does without.
struct ElementaryAddresses {
  std::uint32_t exponential;
  std::uint32_t power;
  std::uint32_t arc_cosine;
};

ElementaryAddresses elementary_addresses(const LinkedProgram& program) {
  return {address_of(program, "ffp_exponential"), address_of(program, "ffp_power"),
          address_of(program, "ffp_arc_cosine")};
}

/// A compiled function: arguments behind the return address on the stack, the result in D0.
template <class Compute>
auto compiled(Operation operation, firmware::Work& work, Compute compute) {
  return [operation, &work, compute](ExecutionUnit& unit) {
    constexpr std::uint32_t k_long_bytes = 4;
    const auto argument = [&unit](std::uint32_t number) {
      return from_ffp(unit.memory.read<models::mc68000::OperandSize::long_word>(
          unit.registers.stack() + k_long_bytes * number));
    };
    ++work[operation];
    unit.registers.data(0) = to_ffp(compute(argument));
    unit.return_from_subroutine();
  };
}

void add_elementary(const ElementaryAddresses& at, NativeCalls& routines, firmware::Work& work) {
  if (at.exponential != 0) {
    routines.add(at.exponential, compiled(Operation::exponential, work, [](const auto& argument) {
                   return firmware::exponential(argument(1));
                 }));
  }
  if (at.power != 0) {
    routines.add(at.power, compiled(Operation::power, work, [](const auto& argument) {
                   return firmware::power(argument(1), argument(2));
                 }));
  }
  if (at.arc_cosine != 0) {
    routines.add(at.arc_cosine, compiled(Operation::arc_cosine, work, [](const auto& argument) {
                   return firmware::arc_cosine(argument(1));
                 }));
  }
}

}  // namespace

models::HostRoutines host_arithmetic(const LinkedProgram& program) {
  return [package = program.package, elementary = elementary_addresses(program)](
             models::mc68000::NativeCalls& routines, firmware::Work& work) {
    add_package(package, routines, work);
    add_elementary(elementary, routines, work);
  };
}

}  // namespace maquette::sim
