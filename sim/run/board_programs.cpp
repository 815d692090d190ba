#include "sim/run/board_programs.hpp"

#include <stdexcept>

#include "sim/database/board_image.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/board_start.hpp"
#include "sim/run/execution_check.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

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
  firmware::BoardOrder order = board_order(machine, setup);
  const firmware::NumberFormat numbers = models::numbers_of(machine.parameters.board.arithmetic);
  models::ProgramSetup program;
  for (std::size_t board = 0; board < machine.parameters.boards.size(); ++board) {
    order.first_unit = static_cast<std::uint32_t>(board);
    const BoardImage image =
        board_image(numbers, scene.frame(), area.view(), order, board_room(machine));
    add_board(image, machine.parameters.host.loads_code, program, setup);
    program.entry = program_entry(image);
    program.host_routines = host_routines(machine, image);
  }
  return program;
}

}  // namespace

void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup) {
  require_execution(machine);
  setup.images.clear();
  try {
    setup.program = programs_of(packed, machine, setup);
  } catch (const std::out_of_range& error) {
    throw DescriptionError(std::string("the boards can not execute their program: ") +
                           error.what() + "; raise board.ram");
  }
  setup.program->threads = threads;
}

}  // namespace maquette::sim
