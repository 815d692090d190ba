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
std::uint64_t end_of_addresses(const models::MachineParameters& parameters,
                               std::size_t shared_database_bytes) {
  const models::MachineAddresses addresses =
      models::machine_addresses(parameters, shared_database_bytes);
  const std::uint64_t pixels = static_cast<std::uint64_t>(parameters.frame_memory.width) *
                               static_cast<std::uint64_t>(parameters.frame_memory.height);
  const bool shares = models::is_claimed(parameters.allotment.assignment) ||
                      models::is_shared(parameters.board.database);
  return shares ? addresses.shared.database() + shared_database_bytes
                : addresses.frame.base + pixels * models::FrameMemory::k_pixel_bytes;
}

}  // namespace

std::optional<std::string> obstacle_to_execution(const Machine& machine,
                                                 std::size_t shared_database_bytes) {
  constexpr int k_word_bits = 16;
  const models::MachineParameters& parameters = machine.parameters;
  const models::ArithmeticCosts& arithmetic = parameters.board.arithmetic;
  if (arithmetic.execution == models::ArithmeticExecution::none) {
    return fmt::format(
        "{} is no package of routines on an MC68000; set "
        "board.arithmetic=motorola_ffp, maquette_ffp or ieee_single",
        machine.tables.arithmetic);
  }
  if (models::has_own_package(arithmetic.execution) &&
      models::numbers_of(arithmetic) != firmware::NumberFormat::ffp) {
    return "there is only a package of FFP numbers to execute; set "
           "board.arithmetic.execution=costs or board.arithmetic=maquette_ffp";
  }
  if (models::is_shared(parameters.board.database) && parameters.board.database_cache_bytes > 0) {
    return "a cache of a shared database is known by the law of its hits alone; set "
           "board.database_cache=\"0 byte\"";
  }
  if (parameters.bus.data_width_bits != k_word_bits) {
    return "an MC68000 has a data bus of 16 bits; set bus.data_width=\"16 bits\"";
  }
  if (const std::uint64_t end = end_of_addresses(parameters, shared_database_bytes);
      end > k_addresses) {
    return fmt::format(
        "its 24 bits of address reach 16 Mbyte, and the memories of {} boards, of the picture and "
        "of what boards share end at {:.1f} Mbyte; take fewer processors or a smaller picture",
        parameters.boards.size(), static_cast<double>(end) / k_mbyte);
  }
  return std::nullopt;
}

Machine board_alone(Machine machine) {
  machine.parameters.boards.resize(1);
  machine.parameters.frame_memory.place.reset();
  return machine;
}

void require_execution(const Machine& machine, std::size_t shared_database_bytes) {
  if (const std::optional<std::string> obstacle =
          obstacle_to_execution(machine, shared_database_bytes)) {
    throw DescriptionError("the boards can not execute their program: " + *obstacle);
  }
}

}  // namespace maquette::sim
