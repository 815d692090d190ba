#include "sim/run/host_arithmetic.hpp"

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/arithmetic/number_format.hpp"
#include "firmware/arithmetic/real.hpp"
#include "sim/run/host_routine.hpp"

namespace maquette::sim {

namespace {

using firmware::Operation;
using models::mc68000::ExecutionUnit;
using models::mc68000::NativeCalls;

/// A routine of two operands; with a zero operand, or a zero result of a product, it is another
/// operation to the cost tables.
template <class Format, class Compute>
auto binary(Operation operation, Operation with_zero, firmware::Work& work, Compute compute) {
  return [operation, with_zero, &work, compute](ExecutionUnit& unit) {
    const float left = number_in<Format>(unit, k_left);
    const float right = number_in<Format>(unit, k_right);
    const std::uint32_t result = Format::bits_of(compute(left, right));
    const bool zero = left == 0 || (right == 0 && operation != Operation::divide) ||
                      (Format::magnitude(result) == 0 && operation == Operation::multiply);
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

template <class Format>
void add_operators(std::uint32_t at, const firmware::ArithmeticPackage& package,
                   NativeCalls& routines, firmware::Work& work) {
  routines.add(at + package.add, binary<Format>(Operation::add, Operation::add_zero, work,
                                                [](float a, float b) { return a + b; }));
  routines.add(at + package.subtract, binary<Format>(Operation::subtract, Operation::subtract_zero,
                                                     work, [](float a, float b) { return a - b; }));
  routines.add(at + package.multiply, binary<Format>(Operation::multiply, Operation::multiply_zero,
                                                     work, [](float a, float b) { return a * b; }));
  routines.add(at + package.divide, binary<Format>(Operation::divide, Operation::divide_zero, work,
                                                   [](float a, float b) { return a / b; }));
  routines.add(at + package.compare, [&work](ExecutionUnit& unit) {
    ++work[Operation::compare];
    set_comparison<Format>(unit);
    unit.return_from_subroutine();
  });
}

template <class Format>
void add_conversions(std::uint32_t at, const firmware::ArithmeticPackage& package,
                     NativeCalls& routines, firmware::Work& work) {
  routines.add(at + package.square_root,
               unary(Operation::square_root, work, [](std::uint32_t bits) {
                 return Format::bits_of(firmware::square_root(Format::value_of(bits)));
               }));
  routines.add(at + package.to_integer,
               unary(Operation::float_to_integer, work, [](std::uint32_t bits) {
                 return static_cast<std::uint32_t>(firmware::to_integer(Format::value_of(bits)));
               }));
  routines.add(at + package.from_integer,
               unary(Operation::integer_to_float, work, [](std::uint32_t bits) {
                 return Format::bits_of(static_cast<float>(static_cast<std::int32_t>(bits)));
               }));
}

/// Where the firmware's elementary functions are in a board's RAM; k_left_out where a scene does
/// without.
struct ElementaryAddresses {
  std::uint32_t exponential;
  std::uint32_t power;
  std::uint32_t arc_cosine;
};

ElementaryAddresses elementary_addresses(const LinkedProgram& program) {
  return {address_of(program, "arithmetic_exponential"), address_of(program, "arithmetic_power"),
          address_of(program, "arithmetic_arc_cosine")};
}

/// A compiled function: arguments behind the return address on the stack, the result in D0.
template <class Format, class Compute>
auto compiled(Operation operation, firmware::Work& work, Compute compute) {
  return [operation, &work, compute](ExecutionUnit& unit) {
    constexpr std::uint32_t k_long_bytes = 4;
    const auto argument = [&unit](std::uint32_t number) {
      return Format::value_of(unit.memory.read<models::mc68000::OperandSize::long_word>(
          unit.registers.stack() + k_long_bytes * number, 0));
    };
    ++work[operation];
    unit.registers.data(0) = Format::bits_of(compute(argument));
    unit.return_from_subroutine();
  };
}

template <class Format>
void add_elementary(const ElementaryAddresses& at, NativeCalls& routines, firmware::Work& work) {
  const auto add = [&](std::uint32_t address, Operation operation, auto compute) {
    if (address != k_left_out) {
      routines.add(address, compiled<Format>(operation, work, compute));
    }
  };
  add(at.exponential, Operation::exponential,
      [](const auto& argument) { return firmware::exponential(argument(1)); });
  add(at.power, Operation::power,
      [](const auto& argument) { return firmware::power(argument(1), argument(2)); });
  add(at.arc_cosine, Operation::arc_cosine,
      [](const auto& argument) { return firmware::arc_cosine(argument(1)); });
}

template <class Format>
models::HostRoutines routines_of(const LinkedProgram& program) {
  return [at = program.package, code = program.code, elementary = elementary_addresses(program)](
             models::mc68000::NativeCalls& routines, firmware::Work& work) {
    add_operators<Format>(at, code->package, routines, work);
    add_conversions<Format>(at, code->package, routines, work);
    add_elementary<Format>(elementary, routines, work);
  };
}

}  // namespace

models::HostRoutines host_arithmetic(const LinkedProgram& program) {
  return program.code->numbers == firmware::NumberFormat::ffp
             ? routines_of<firmware::FfpFormat>(program)
             : routines_of<firmware::IeeeSingleFormat>(program);
}

}  // namespace maquette::sim
