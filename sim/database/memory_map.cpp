#include "sim/database/memory_map.hpp"

#include <fmt/format.h>

#include "sim/database/board_stack.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/database/ram_layout.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// Places of one use that follow one another make one row.
std::vector<MemoryUse> uses_of(const RamLayout& layout) {
  std::vector<MemoryUse> uses;
  for (const RamPlace& place : layout.places) {
    if (uses.empty() || uses.back().name != place.use) {
      uses.push_back({std::string{place.use}, place.address, 0});
    }
    uses.back().bytes += place.bytes;
  }
  return uses;
}

void refuse_above(const SourcePosition& position, std::int64_t needed, std::int64_t available,
                  const char* what, const char* parameter) {
  if (needed > available) {
    throw DescriptionError(
        position, fmt::format("the scene needs {} {}, the board has {}; raise {}", needed, what,
                              available, parameter));
  }
}

}  // namespace

MemoryMap memory_map_of(const PackedScene<float>& scene, const Machine& machine) {
  const firmware::Database<float> database = scene.database();
  firmware::BoardTask<float> task{};
  task.frame.database = database;
  const firmware::NumberFormat numbers = models::numbers_of(machine.parameters.board.arithmetic);
  const BoardPieces pieces =
      needed_pieces(program_code(numbers), database.needs, machine.parameters.allotment.order);
  const RamLayout layout = ram_layout(task, scene.conversion(), pieces, board_room(machine));
  MemoryMap map;
  map.uses = uses_of(layout);
  map.used_bytes = layout.used_bytes;
  map.ram_bytes = machine.parameters.board.ram_bytes;
  map.loaded_bytes =
      layout.loaded_end -
      (machine.parameters.host.loads_code ? machine.system_bytes : layout.first_loaded_data);
  map.crossings_needed = crossing_needs_of(database).space;
  map.rays_needed = firmware::pending_rays_needed(database.ray_depth, database.needs.transparency);
  map.stack_needed_bytes = board_stack_bytes(pieces, scene.tree_height);
  return map;
}

void check_memory(const MemoryMap& map, const Machine& machine, const SourcePosition& position) {
  refuse_above(position, map.crossings_needed, machine.crossing_capacity, "crossings of a ray",
               "board.crossings");
  refuse_above(position, map.rays_needed, machine.ray_capacity, "waiting rays",
               "board.waiting_rays");
  refuse_above(position, map.stack_needed_bytes, machine.stack_bytes, "bytes of stack",
               "board.stack");
  if (!map.fits() && !machine.allow_memory_overflow) {
    throw DescriptionError(
        position, fmt::format("the scene takes {} bytes of a board's RAM, {} more than its {}; "
                              "raise board.ram, or set "
                              "board.allow_overflow=true to simulate it all the same",
                              map.used_bytes, map.used_bytes - map.ram_bytes, map.ram_bytes));
  }
}

}  // namespace maquette::sim
