#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "firmware/board_order.hpp"
#include "firmware/conversion.hpp"
#include "sim/database/board_code.hpp"
#include "sim/database/board_room.hpp"

namespace maquette::sim {

/// A part of a board's RAM.
struct RamPlace {
  std::string_view use;
  /// What of the host's structures has its place here; of a line of pixels, the field with its
  /// address; of own pixels, that of the frame memory in whose place they are.
  const void* object;
  std::int64_t address;
  std::int64_t bytes;
};

/// What a board's RAM holds, from the bottom up without gaps, but for the stack at the top.
struct RamLayout {
  std::vector<RamPlace> places;
  std::int64_t first_loaded_data;  ///< address; behind the program
  std::int64_t loaded_end;         ///< behind what the host loads
  std::int64_t used_bytes;         ///< the stack included

  [[nodiscard]] bool fits(const BoardRoom& room) const { return used_bytes <= room.ram_bytes; }
};

/// What units write into a board's RAM begins here.
inline constexpr std::string_view k_in_flight_use = "pixels in flight";

/// Lays out a board's RAM for a task by firmware/layout.hpp: system, program, the scene's arrays,
/// the task with its conversion, what preprocessing makes of them, work area, line of pixels, own
/// pixels, pixels in flight, stack. Of those each has a mailbox, and all but one a work area and a
/// stack of their own.
[[nodiscard]] RamLayout ram_layout(const firmware::BoardTask<float>& task,
                                   const firmware::Conversion<float>& conversion,
                                   const BoardPieces& pieces, const BoardRoom& room);

/// Calls `visit(first, count)` for each array of a scene that is loaded, in their order in memory.
template <class Visit>
void for_each_array(const firmware::Database<float>& database,
                    const firmware::Conversion<float>& conversion, Visit visit) {
  visit(database.leaves, std::size_t{database.leaf_count});
  visit(database.composites, std::size_t{database.composite_count});
  if (conversion.given_count > 0) {
    visit(conversion.given, std::size_t{conversion.given_count});
  } else {
    visit(database.parameters, std::size_t{database.parameter_count});
  }
  visit(database.surfaces, std::size_t{database.surface_count});
  visit(database.lights, std::size_t{database.light_count});
  const firmware::Needs& needs = database.needs;
  visit(database.surface_ambients,
        std::size_t{needs.surface_ambient ? database.surface_count : 0U});
  visit(database.light_shapes, std::size_t{needs.shaped_lights ? database.light_count : 0U});
  visit(database.leaf_textures, std::size_t{needs.textured ? database.leaf_count : 0U});
  visit(database.textures, std::size_t{database.texture_count});
  visit(database.texels, std::size_t{database.texel_count} * firmware::k_texel_bytes);
}

}  // namespace maquette::sim
