#include "sim/run/execution_check.hpp"

#include <fmt/format.h>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

std::optional<std::string> obstacle_to_execution(const Machine& machine) {
  constexpr int k_word_bits = 16;
  const models::MachineParameters& parameters = machine.parameters;
  const models::ArithmeticCosts& arithmetic = parameters.board.arithmetic;
  if (arithmetic.execution == models::ArithmeticExecution::none) {
    return fmt::format(
        "{} is no package of routines on an MC68000; set "
        "board.arithmetic=motorola_ffp, maquette_ffp or ieee_single",
        machine.arithmetic_name);
  }
  if (arithmetic.execution == models::ArithmeticExecution::package &&
      models::numbers_of(arithmetic) != firmware::NumberFormat::ffp) {
    return "there is only a package of FFP numbers to execute; set "
           "board.arithmetic.execution=costs or board.arithmetic=maquette_ffp";
  }
  if (models::is_shared(parameters.board.database)) {
    return "it reads the scene from the board's own RAM; set board.database=own_copy";
  }
  if (parameters.bus.data_width_bits != k_word_bits) {
    return "an MC68000 has a data bus of 16 bits; set bus.data_width=\"16 bits\"";
  }
  return std::nullopt;
}

void require_execution(const Machine& machine) {
  if (const std::optional<std::string> obstacle = obstacle_to_execution(machine)) {
    throw DescriptionError("the boards can not execute their program: " + *obstacle);
  }
}

}  // namespace maquette::sim
