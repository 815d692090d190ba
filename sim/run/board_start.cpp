#include "sim/run/board_start.hpp"

#include "models/machine/machine_addresses.hpp"
#include "sim/run/exact_arithmetic.hpp"
#include "sim/run/host_arithmetic.hpp"

namespace maquette::sim {

namespace {

firmware::ComponentPlace place_of(int bits, int shift) {
  return {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(shift)};
}

/// Of a display with depths: red, green and blue side by side in the upper word.
void set_components(const models::FrameMemoryParameters& frame, firmware::BoardOrder& order) {
  constexpr int k_word_bits = 16;
  order.has_depth = frame.depth_bits > 0;
  order.red = place_of(frame.red_bits, k_word_bits + frame.green_bits + frame.blue_bits);
  order.green = place_of(frame.green_bits, k_word_bits + frame.blue_bits);
  order.blue = place_of(frame.blue_bits, k_word_bits);
}

void set_units(const Machine& machine, int zone_width, firmware::BoardOrder& order) {
  const models::AllotmentParameters& allotment = machine.parameters.allotment;
  order.unit_width = 1;
  order.unit_height = 1;
  switch (allotment.order) {
    case models::Allotment::interleaved_pixels:
      break;
    case models::Allotment::interleaved_lines:
      order.unit_width = static_cast<std::uint16_t>(zone_width);
      break;
    case models::Allotment::bands:
      order.bands = static_cast<std::uint16_t>(machine.parameters.boards.size());
      break;
    case models::Allotment::tiles:
      order.unit_width = static_cast<std::uint16_t>(allotment.tile_width);
      order.unit_height = static_cast<std::uint16_t>(allotment.tile_height);
      break;
    case models::Allotment::interlaced: {
      const models::Interlace interlace =
          models::interlace_of(allotment, static_cast<int>(machine.parameters.boards.size()));
      order.unit_width = static_cast<std::uint16_t>(interlace.columns);
      order.unit_height = static_cast<std::uint16_t>(interlace.lines);
      break;
    }
  }
}

}  // namespace

std::uint32_t shared_database_address(const Machine& machine) {
  return static_cast<std::uint32_t>(
      models::machine_addresses(machine.parameters, 0).shared.database());
}

firmware::BoardOrder board_order(const Machine& machine, const models::FrameSetup& setup) {
  const models::MachineParameters& parameters = machine.parameters;
  const models::MachineAddresses addresses =
      models::machine_addresses(parameters, setup.shared_database.size());
  firmware::BoardOrder order{};
  order.unit_step = static_cast<std::uint32_t>(parameters.boards.size());
  order.frame_width = static_cast<std::uint16_t>(parameters.frame_memory.width);
  order.frame_memory = static_cast<std::uint32_t>(addresses.frame.base);
  if (models::is_claimed(parameters.allotment.assignment)) {
    order.lock = static_cast<std::uint32_t>(addresses.shared.lock());
  }
  set_units(machine, setup.useful_zone.width, order);
  set_components(parameters.frame_memory, order);
  return order;
}

models::ProgramEntry program_entry(const BoardImage& image) {
  const std::uint32_t interlaced = address_of(image.program, "interlaced_synthesis");
  return {beginning_of(image.program), image.stack,
          interlaced != k_left_out ? interlaced : address_of(image.program, "board_synthesis")};
}

models::HostRoutines host_routines(const Machine& machine, const BoardImage& image) {
  switch (machine.parameters.board.arithmetic.execution) {
    case models::ArithmeticExecution::package:
      return {};
    case models::ArithmeticExecution::exact:
      return exact_arithmetic(image.program);
    case models::ArithmeticExecution::none:
    case models::ArithmeticExecution::costs:
      break;
  }
  return host_arithmetic(image.program);
}

}  // namespace maquette::sim
