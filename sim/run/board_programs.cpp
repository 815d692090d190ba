#include "sim/run/board_programs.hpp"

#include "sim/database/board_image.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/board_start.hpp"
#include "sim/run/changed_ranges.hpp"
#include "sim/run/execution_check.hpp"

namespace maquette::sim {

namespace {

std::vector<unsigned char> part(const std::vector<unsigned char>& ram, std::size_t first,
                                std::size_t end) {
  return {ram.begin() + static_cast<std::ptrdiff_t>(first),
          ram.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Where an image begins that the host loads.
std::uint32_t loaded_from(const BoardImage& image, const Machine& machine) {
  return machine.parameters.host.loads_code ? image.program.base : image.database;
}

/// Makes the image of each board, and shows it to `take`.
template <class Take>
void make_images(const PackedScene<float>& packed, const Machine& machine,
                 models::FrameSetup& setup, Take take) {
  const PreparedScene<float> scene(packed);
  SynthesisArea<float> area(scene.frame().database);
  const firmware::NumberFormat numbers = models::numbers_of(machine.parameters.board.arithmetic);
  if (models::is_shared(machine.parameters.board.database)) {
    setup.shared_database = database_image(scene.packed(), numbers);
  }
  const BoardRoom room = board_room(machine, shared_database_address(machine));
  firmware::BoardOrder order = board_order(machine, setup);
  for (std::size_t board = 0; board < machine.parameters.boards.size(); ++board) {
    order.first_unit = static_cast<std::uint32_t>(board);
    const BoardImage image = board_image(numbers, scene, area.view(), order, room);
    setup.image_address = loaded_from(image, machine);
    setup.pixel_address = image.own_pixels;
    setup.images.push_back(part(image.ram, setup.image_address, image.loaded_end));
    take(image);
  }
}

/// What is in a board's RAM without being loaded: a program that is not loaded, and the stack.
std::vector<models::RamPart> resident_parts(const BoardImage& image, const Machine& machine) {
  const std::uint32_t loaded = loaded_from(image, machine);
  return {{image.program.base, part(image.ram, image.program.base, loaded)},
          {image.stack, part(image.ram, image.stack, image.ram.size())}};
}

}  // namespace

void set_images(const PackedScene<float>& packed, const Machine& machine,
                models::FrameSetup& setup) {
  make_images(packed, machine, setup, [](const BoardImage& /*image*/) {});
}

void load_changes(const models::FrameSetup& before, const Machine& machine,
                  models::FrameSetup& setup) {
  if (before.images.empty() || setup.images.empty() ||
      before.image_address != setup.image_address) {
    return;
  }
  const auto word_bytes = static_cast<std::size_t>(machine.parameters.bus.data_width_bits / 8);
  if (before.unit_images.size() == setup.unit_images.size()) {
    for (std::size_t unit = 0; unit < setup.unit_images.size(); ++unit) {
      setup.unit_loaded.push_back(
          changed_ranges(before.unit_images[unit], setup.unit_images[unit], word_bytes));
    }
  }
  // The boards' images differ in what each is told of its share, which stays from frame to frame.
  setup.loaded = changed_ranges(before.images.front(), setup.images.front(), word_bytes);
  if (setup.program) {
    for (std::size_t board = 0; board < setup.images.size(); ++board) {
      setup.program->resident.at(board).push_back({setup.image_address, setup.images[board]});
    }
  } else {
    setup.shared_loaded = changed_ranges(before.shared_database, setup.shared_database, word_bytes);
  }
}

void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup) {
  require_execution(machine);
  models::ProgramSetup program;
  make_images(packed, machine, setup, [&](const BoardImage& image) {
    program.resident.push_back(resident_parts(image, machine));
    program.entry = program_entry(image);
    program.host_routines = host_routines(machine, image);
  });
  require_execution(machine, setup.shared_database.size());
  program.threads = threads;
  setup.program = std::move(program);
}

}  // namespace maquette::sim
