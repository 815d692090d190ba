#include "sim/run/execution_check.hpp"

#include <fmt/format.h>

#include "models/display/frame_memory.hpp"
#include "models/machine/machine_addresses.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr std::uint64_t k_addresses = std::uint64_t{1} << 24U;  // of an MC68000
constexpr std::uint64_t k_mbyte = std::uint64_t{1} << 20U;

/// Where what a program reads and writes ends.
std::uint64_t end_of_addresses(const models::MachineParameters& parameters) {
  const models::MachineAddresses addresses = models::machine_addresses(parameters, 0);
  const std::uint64_t pixels = static_cast<std::uint64_t>(parameters.frame_memory.width) *
                               static_cast<std::uint64_t>(parameters.frame_memory.height);
  return models::is_claimed(parameters.allotment.assignment)
             ? addresses.shared.base + models::SharedWindow::k_header_bytes
             : addresses.frame.base + pixels * models::FrameMemory::k_pixel_bytes;
}

}  // namespace

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
  if (models::has_own_package(arithmetic.execution) &&
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
  if (const std::uint64_t end = end_of_addresses(parameters); end > k_addresses) {
    return fmt::format(
        "its 24 bits of address reach 16 Mbyte, and the memories of {} boards and of the picture "
        "end at {:.1f} Mbyte; take fewer processors or a smaller picture",
        parameters.boards.size(), static_cast<double>(end) / k_mbyte);
  }
  return std::nullopt;
}

Machine board_alone(Machine machine) {
  machine.parameters.boards.resize(1);
  return machine;
}

void require_execution(const Machine& machine) {
  if (const std::optional<std::string> obstacle = obstacle_to_execution(machine)) {
    throw DescriptionError("the boards can not execute their program: " + *obstacle);
  }
}

}  // namespace maquette::sim
