#include "sim/machine/unit_checks.hpp"

#include <cstdint>
#include <string>
#include <string_view>

#include "models/machine/address_blocks.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

void require(bool holds, const YamlNode& root, std::string_view path, const std::string& message) {
  if (!holds) {
    throw DescriptionError(nearest_node(root, path).place.position(),
                           std::string{path} + ": " + message);
  }
}

/// As most_pixels_in_flight, with what is allowed.
void check_in_flight(const models::MachineParameters& parameters, const YamlNode& root) {
  const auto boards = static_cast<std::int64_t>(parameters.boards.size());
  const std::int64_t most = models::most_pixels_in_flight(parameters.units);
  const std::int64_t pixels = boards * parameters.units.in_flight;
  require(pixels <= most, root, "units.in_flight",
          std::to_string(pixels) + " pixels in flight on " + std::to_string(boards) +
              " boards could fill two kinds of units that wait for each other; " +
              (most < boards
                   ? "fewer boards or a longer queue are allowed"
                   : "up to " + std::to_string(most / boards) + " or a longer queue are allowed"));
}

void check_addresses(const models::MachineParameters& parameters, const YamlNode& root) {
  const std::uint64_t block = models::block_of(parameters.board.ram_bytes);
  const std::uint64_t of_unit = models::unit_block(parameters.units);
  std::uint64_t units = 0;
  for (const models::FunctionUnitParameters& kind : parameters.units.kinds) {
    units += static_cast<std::uint64_t>(kind.number);
  }
  const std::uint64_t shared =
      models::shared_base(block, parameters.boards.size(), parameters.frame_memory);
  require(
      models::units_base(shared + block, of_unit) + units * of_unit <= models::k_end_of_addresses,
      root, "units",
      "boards, frame memory and so many units need more than the 32 bits of the bus's "
      "addresses; fewer units or less RAM are allowed");
}

/// The events of the boards' program are not what a processor of its own does.
void check_costs(const YamlNode& root) {
  for (const char* const kind : models::k_unit_kind_names) {
    const std::string path = std::string("units.") + kind;
    const YamlNode& unit = nearest_node(root, path);
    if (unit.kind != YamlKind::mapping) {
      continue;
    }
    const bool has_arithmetic = unit.find("arithmetic") != nullptr;
    const bool has_program = unit.find("program") != nullptr;
    require(has_program || !has_arithmetic, root, path,
            "a unit with costs of its own has them of all its work; arithmetic is allowed with "
            "program");
    require(has_arithmetic || !has_program, root, path,
            "a unit with costs of its own has them of all its work; program is allowed with "
            "arithmetic");
  }
}

}  // namespace

void check_units(const Machine& machine, const YamlNode& root) {
  const models::MachineParameters& parameters = machine.parameters;
  if (!models::has_units(parameters.units)) {
    return;
  }
  check_costs(root);
  require(!models::is_shared(parameters.board.database), root, "board.database",
          "boards that hand out errands have copies; own_copy is allowed");
  require(!models::keeps_line(parameters.board.pixel_write), root, "board.pixel_write",
          "boards that hand out errands write each pixel when it is done; pixel is allowed");
  require(parameters.frame_memory.ports == 1, root, "frame_memory.ports",
          "boards and units are on one backplane; 1 is allowed");
  check_in_flight(parameters, root);
  check_addresses(parameters, root);
}

}  // namespace maquette::sim
