#include "sim/run/execution_check.hpp"

#include <fmt/format.h>

#include "models/display/frame_memory.hpp"
#include "models/machine/machine_addresses.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// Behind the last address that a board's program uses.
std::uint64_t address_end(const models::MachineParameters& parameters) {
  const models::MachineAddresses addresses = models::machine_addresses(parameters, 0);
  if (models::is_claimed(parameters.allotment.assignment)) {
    return addresses.shared.base + models::SharedWindow::k_header_bytes;
  }
  const auto pixels = static_cast<std::uint64_t>(parameters.frame_memory.width) *
                      static_cast<std::uint64_t>(parameters.frame_memory.height);
  return addresses.frame.base + pixels * models::FrameMemory::k_pixel_bytes;
}

}  // namespace

std::optional<std::string> obstacle_to_execution(const Machine& machine) {
  constexpr int k_word_bits = 16;
  constexpr std::uint64_t k_address_space_bytes = std::uint64_t{1} << 24U;
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
  if (address_end(parameters) > k_address_space_bytes) {
    return fmt::format(
        "the {} boards' memories and the frame memory do not fit the 16 MiB that an MC68000 "
        "addresses; set fewer processors",
        parameters.boards.size());
  }
  return std::nullopt;
}

void require_execution(const Machine& machine) {
  if (const std::optional<std::string> obstacle = obstacle_to_execution(machine)) {
    throw DescriptionError("the boards can not execute their program: " + *obstacle);
  }
}

}  // namespace maquette::sim
