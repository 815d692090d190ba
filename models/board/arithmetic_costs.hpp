#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/arithmetic/number_format.hpp"
#include "firmware/arithmetic/work.hpp"

namespace maquette::models {

/// Cost of one operation on a processor: clocks without wait states, and the 16-bit bus reads and
/// writes among them, each of which pays the RAM's wait states (hardware.md section 4). Means over
/// operands may be fractional.
struct OperationCost {
  double clocks = 0;
  double reads = 0;
  double writes = 0;
};

/// How boards that execute their program do arithmetic with a table's package: none of them can (it
/// is no package of routines on an MC68000), the host does it and each call costs what the table
/// says, or exactly what the project's package takes on its operands, or that package itself is
/// executed (it is of FFP numbers).
enum class ArithmeticExecution { none, costs, exact, package };

/// Whether boards have the project's own package.
constexpr bool has_own_package(ArithmeticExecution execution) {
  switch (execution) {
    case ArithmeticExecution::exact:
    case ArithmeticExecution::package:
      return true;
    case ArithmeticExecution::none:
    case ArithmeticExecution::costs:
      break;
  }
  return false;
}

/// The cost of every operation class, of arithmetic from a table of models/arithmetic/ and of
/// events from one of models/program/, and which of them are calls of the arithmetic package (they
/// pay the board's call overhead; in-line ones and events do not).
struct ArithmeticCosts {
  std::array<OperationCost, firmware::k_operation_count> operations{};
  std::array<bool, firmware::k_operation_count> called{};
  std::int64_t package_bytes = 0;  ///< code of the package in a board's RAM
  ArithmeticExecution execution = ArithmeticExecution::none;
  std::optional<firmware::NumberFormat> numbers;  ///< of the boards' program; FFP without
};

/// The format of the numbers that boards which execute their program have in it.
inline firmware::NumberFormat numbers_of(const ArithmeticCosts& costs) {
  return costs.numbers.value_or(firmware::NumberFormat::ffp);
}

}  // namespace maquette::models
