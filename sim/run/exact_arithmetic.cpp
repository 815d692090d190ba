#include "sim/run/exact_arithmetic.hpp"

#include "firmware/arithmetic/number_format.hpp"
#include "firmware/arithmetic/real.hpp"
#include "models/board/maquette_ffp/routine_cost.hpp"
#include "sim/run/host_routine.hpp"

namespace maquette::sim {

namespace {

using firmware::FfpFormat;
using models::RoutineCost;
using models::mc68000::ExecutionUnit;
using models::mc68000::NativeCalls;

/// The account tells fetches from reads nowhere that matters: both are reads of the RAM.
void charge(const RoutineCost& cost, ExecutionUnit& unit) {
  unit.counter.charge(models::mc68000::packed({cost.cycles, cost.reads, 0, cost.writes}));
}

template <class Cost, class Compute>
auto binary(Cost cost, Compute compute) {
  return [cost, compute](ExecutionUnit& unit) {
    charge(cost(unit.registers.data(k_left), unit.registers.data(k_right)), unit);
    unit.registers.data(k_left) = FfpFormat::bits_of(
        compute(number_in<FfpFormat>(unit, k_left), number_in<FfpFormat>(unit, k_right)));
    unit.return_from_subroutine();
  };
}

template <class Cost, class Compute>
auto unary(Cost cost, Compute compute) {
  return [cost, compute](ExecutionUnit& unit) {
    const std::uint32_t operand = unit.registers.data(k_left);
    charge(cost(operand), unit);
    unit.registers.data(k_left) = compute(operand);
    unit.return_from_subroutine();
  };
}

void compare(ExecutionUnit& unit) {
  charge(models::compare_cost(unit.registers.data(k_left), unit.registers.data(k_right)), unit);
  set_comparison<FfpFormat>(unit);
  unit.return_from_subroutine();
}

void add_routines(std::uint32_t at, const firmware::ArithmeticPackage& package,
                  NativeCalls& routines) {
  routines.add(at + package.add, binary(models::add_cost, [](float a, float b) { return a + b; }));
  routines.add(at + package.subtract,
               binary(models::subtract_cost, [](float a, float b) { return a - b; }));
  routines.add(at + package.multiply,
               binary(models::multiply_cost, [](float a, float b) { return a * b; }));
  routines.add(at + package.divide,
               binary(models::divide_cost, [](float a, float b) { return a / b; }));
  routines.add(at + package.compare, compare);
  routines.add(at + package.square_root, unary(models::square_root_cost, [](std::uint32_t bits) {
                 return FfpFormat::bits_of(firmware::square_root(FfpFormat::value_of(bits)));
               }));
  routines.add(at + package.to_integer, unary(models::to_integer_cost, [](std::uint32_t bits) {
                 return static_cast<std::uint32_t>(firmware::to_integer(FfpFormat::value_of(bits)));
               }));
  routines.add(at + package.from_integer, unary(models::from_integer_cost, [](std::uint32_t bits) {
                 return FfpFormat::bits_of(static_cast<float>(static_cast<std::int32_t>(bits)));
               }));
}

}  // namespace

models::HostRoutines exact_arithmetic(const LinkedProgram& program) {
  return
      [at = program.package, code = program.code](NativeCalls& routines, firmware::Work& /*work*/) {
        add_routines(at, code->package, routines);
      };
}

}  // namespace maquette::sim
