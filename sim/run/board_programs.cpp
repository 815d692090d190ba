#include "sim/run/board_programs.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/database/board_image.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/host_arithmetic.hpp"
#include "sim/yaml/description_error.hpp"

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
  }
}

/// What board 0 is told; the others differ in their first unit.
firmware::BoardOrder order_of(const Machine& machine, const models::FrameSetup& setup) {
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

[[noreturn]] void refuse(const std::string& what) {
  throw DescriptionError("the boards can not execute their program: " + what);
}

}  // namespace

bool executes_package(const Machine& machine) {
  switch (machine.parameters.board.arithmetic.execution) {
    case models::ArithmeticExecution::package:
      return true;
    case models::ArithmeticExecution::costs:
      return false;
    case models::ArithmeticExecution::none:
      break;
  }
  refuse(
      fmt::format("{} is not an arithmetic of FFP numbers on an MC68000; set "
                  "board.arithmetic=motorola_ffp or maquette_ffp",
                  machine.arithmetic_name));
}

BoardRoom board_room(const Machine& machine) {
  const models::Kvm02Parameters& board = machine.parameters.board;
  const bool keeps_line = models::keeps_line(board.pixel_write);
  return {static_cast<std::uint32_t>(board.ram_bytes),
          static_cast<std::uint32_t>(machine.system_bytes),
          static_cast<std::uint32_t>(machine.crossing_capacity),
          static_cast<std::uint32_t>(machine.ray_capacity),
          keeps_line ? static_cast<std::uint32_t>(machine.parameters.frame_memory.width) : 0,
          static_cast<std::uint32_t>(machine.stack_bytes)};
}

namespace {

void check(const Machine& machine) {
  constexpr int k_word_bits = 16;
  const models::MachineParameters& parameters = machine.parameters;
  executes_package(machine);
  if (models::is_shared(parameters.board.database)) {
    refuse("it reads the scene from the board's own RAM; set board.database=own_copy");
  }
  if (parameters.bus.data_width_bits != k_word_bits) {
    refuse("an MC68000 has a data bus of 16 bits; set bus.data_width=\"16 bits\"");
  }
}

std::vector<unsigned char> part(const std::vector<unsigned char>& ram, std::size_t first,
                                std::size_t end) {
  return {ram.begin() + static_cast<std::ptrdiff_t>(first),
          ram.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// What of an image the host loads, and what is in the RAM without: a program that is not loaded,
/// and the stack.
void add_board(const BoardImage& image, bool loads_code, models::ProgramSetup& program,
               models::FrameSetup& setup) {
  const std::uint32_t first = loads_code ? image.program.base : image.database;
  setup.image_address = first;
  setup.images.push_back(part(image.ram, first, image.loaded_end));
  program.resident.push_back({{image.program.base, part(image.ram, image.program.base, first)},
                              {image.stack, part(image.ram, image.stack, image.ram.size())}});
}

models::ProgramSetup programs_of(const PackedScene<float>& packed, const Machine& machine,
                                 models::FrameSetup& setup) {
  const PreparedScene<float> scene(packed);
  SynthesisArea<float> area(scene.frame().database);
  firmware::BoardOrder order = order_of(machine, setup);
  const bool executed = executes_package(machine);
  models::ProgramSetup program;
  for (std::size_t board = 0; board < machine.parameters.boards.size(); ++board) {
    order.first_unit = static_cast<std::uint32_t>(board);
    const BoardImage image = board_image(scene.frame(), area.view(), order, board_room(machine));
    add_board(image, machine.parameters.host.loads_code, program, setup);
    program.entry = {address_of(image.program, "board_program"), image.stack,
                     address_of(image.program, "board_synthesis")};
    program.host_routines = executed ? models::HostRoutines{} : host_arithmetic(image.program);
  }
  return program;
}

}  // namespace

void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup) {
  check(machine);
  setup.images.clear();
  try {
    setup.program = programs_of(packed, machine, setup);
  } catch (const std::out_of_range& error) {
    refuse(std::string(error.what()) + "; raise board.ram");
  }
  setup.program->threads = threads;
}

}  // namespace maquette::sim
