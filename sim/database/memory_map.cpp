#include "sim/database/memory_map.hpp"

#include <fmt/format.h>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/memory_needs.hpp"
#include "sim/database/board_code.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// A board that writes a line of pixels at once keeps them, a long word each, until then.
std::int64_t line_buffer_bytes(const Machine& machine) {
  return models::keeps_line(machine.parameters.board.pixel_write)
             ? std::int64_t{machine.parameters.frame_memory.width} * 4
             : 0;
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

template <class Real>
MemoryMap memory_map_of(const firmware::Database<Real>& database, int tree_height,
                        const Machine& machine) {
  const BoardCode code = board_code_of(database.needs);
  MemoryMap map;
  map.ram_bytes = machine.parameters.board.ram_bytes;
  const bool is_shared = models::is_shared(machine.parameters.board.database);
  map.database_bytes = is_shared ? 0 : firmware::database_bytes(database);
  map.left_out_bytes = code.left_out_bytes;
  map.crossings_needed = crossing_needs_of(database).space;
  map.rays_needed = firmware::pending_rays_needed(database.ray_depth, database.needs.transparency);
  map.stack_needed_bytes = board_stack_bytes(tree_height, database.needs);
  map.uses = {{"system", machine.system_bytes},
              {"firmware code", code.needed_bytes},
              {"arithmetic package", machine.parameters.board.arithmetic.package_bytes},
              {"database", map.database_bytes},
              {"preprocessed data", firmware::prepared_bytes(database)},
              {"crossings", machine.crossing_capacity * firmware::k_crossing_bytes},
              {"waiting rays", machine.ray_capacity * firmware::k_pending_ray_bytes},
              {"line of pixels", line_buffer_bytes(machine)},
              {"stack", machine.stack_bytes}};
  for (const MemoryUse& use : map.uses) {
    map.used_bytes += use.bytes;
  }
  map.loaded_bytes = map.database_bytes;
  if (machine.parameters.host.loads_code) {
    map.loaded_bytes += code.needed_bytes + machine.parameters.board.arithmetic.package_bytes;
  }
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

template MemoryMap memory_map_of<float>(const firmware::Database<float>& database, int tree_height,
                                        const Machine& machine);
template MemoryMap memory_map_of<firmware::Counted>(
    const firmware::Database<firmware::Counted>& database, int tree_height, const Machine& machine);

}  // namespace maquette::sim
