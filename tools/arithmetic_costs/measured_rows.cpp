#include <utility>

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "models/board/maquette_ffp/package_number.hpp"
#include "models/board/maquette_ffp/package_processor.hpp"
#include "tools/arithmetic_costs/measured_cost.hpp"
#include "tools/arithmetic_costs/random_operands.hpp"

namespace maquette::costs {

namespace {

using namespace firmware::maquette_ffp;
using models::PackageNumber;

constexpr int k_executions = 400'000;
constexpr int k_function_executions = 10'000;

struct Operands {
  std::uint32_t d7 = 0;
  std::uint32_t d6 = 0;
};

/// A routine of the package on operands that a function draws.
template <class Draw>
MeasuredCost routine(std::uint32_t entry, const Draw& draw) {
  models::PackageProcessor processor;
  RandomOperands random;
  return measure(k_executions, [&]() -> Execution {
    const Operands operands = draw(random);
    const models::PackageCall call = processor.call(entry, operands.d7, operands.d6);
    return {call.cycles, call.reads, call.writes};
  });
}

Operands two_numbers(RandomOperands& random) {
  const std::uint32_t d7 = random.number();
  return {d7, random.number()};
}

Operands one_zero(RandomOperands& random) {
  const std::uint32_t number = random.number();
  return random.coin() ? Operands{number, 0} : Operands{0, number};
}

/// What a call costs besides (tools/program_costs; whole bus cycles), and how often the function
/// converts an integer.
constexpr Execution k_call{66, 12, 4};
struct CompiledFunction {
  unsigned conversions = 0;
};

/// A function of elementary.hpp as calls of the package, without its loops and moves.
template <class Evaluate>
MeasuredCost function(CompiledFunction compiled, const Evaluate& evaluate) {
  models::PackageProcessor processor;
  RandomOperands random;
  return measure(k_function_executions, [&]() -> Execution {
    models::package_meter() = {};
    evaluate(random);
    const models::PackageMeter meter = models::package_meter();
    const models::PackageCall conversion = processor.call(k_from_integer_entry, 7);
    const std::uint64_t conversions = compiled.conversions;
    const std::uint64_t calls = meter.calls + conversions;
    return {meter.cycles + conversions * conversion.cycles + calls * k_call.cycles,
            meter.reads + conversions * conversion.reads + calls * k_call.reads,
            meter.writes + conversions * conversion.writes + calls * k_call.writes};
  });
}

std::vector<CostRow> operation_rows() {
  const std::string ordinary = "random operands of 2^-4 to 2^4, of either sign";
  const std::string zero = "one of the operands zero, either as often";
  const auto one_number = [](RandomOperands& random) { return Operands{random.number()}; };
  return {
      {"add", routine(k_add_entry, two_numbers), true, 'M', ordinary},
      {"subtract", routine(k_subtract_entry, two_numbers), true, 'M', ordinary},
      {"add_zero", routine(k_add_entry, one_zero), true, 'M', zero},
      {"subtract_zero", routine(k_subtract_entry, one_zero), true, 'M', zero},
      {"multiply", routine(k_multiply_entry, two_numbers), true, 'M', ordinary},
      {"multiply_zero", routine(k_multiply_entry, one_zero), true, 'M', zero},
      {"divide", routine(k_divide_entry, two_numbers), true, 'M', ordinary},
      {"divide_zero",
       routine(k_divide_entry,
               [](RandomOperands& random) {
                 return Operands{0, random.number()};
               }),
       true, 'M', "dividend zero"},
      {"square_root",
       routine(k_square_root_entry,
               [](RandomOperands& random) { return Operands{random.positive_number()}; }),
       true, 'M', "random operands of 2^-4 to 2^4"},
      {"compare", routine(k_compare_entry, two_numbers), true, 'M', ordinary},
      {"absolute", routine(k_absolute_entry, one_number), false, 'M',
       "the routine, taken as the cost in line"},
      {"negate", routine(k_negate_entry, one_number), false, 'M',
       "the routine, taken as the cost in line"},
      {"integer_to_float",
       routine(k_from_integer_entry,
               [](RandomOperands& random) {
                 return Operands{static_cast<std::uint32_t>(random.integer())};
               }),
       true, 'M', "random integers below 1000, of either sign"},
      {"float_to_integer",
       routine(
           k_to_integer_entry,
           [](RandomOperands& random) { return Operands{to_ffp(random.uniform(-1000, 1000))}; }),
       true, 'M', "random numbers below 1000, of either sign"},
  };
}

std::vector<CostRow> function_rows() {
  const std::string of =
      "the calls that firmware/arithmetic/elementary.hpp makes, each with 66 "
      "clocks (12/4) of overhead and without its loops: ";
  return {
      {"exponential",
       function({8},
                [](RandomOperands& random) {
                  firmware::exponential(PackageNumber(random.uniform(-10, 10)));
                }),
       true, 'I', of + "-10 to 10"},
      {"power",
       function({15},
                [](RandomOperands& random) {
                  const float base = random.uniform(0, 1);
                  firmware::power(PackageNumber(base), PackageNumber(random.uniform(0, 20)));
                }),
       true, 'I', of + "base 0 to 1, exponent 0 to 20"},
      {"arc_cosine",
       function({11},
                [](RandomOperands& random) {
                  firmware::arc_cosine(PackageNumber(random.uniform(0, 1)));
                }),
       true, 'I', of + "0 to 1"},
  };
}

}  // namespace

std::vector<CostRow> measured_rows() {
  std::vector<CostRow> rows = operation_rows();
  for (CostRow& row : function_rows()) {
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace maquette::costs
