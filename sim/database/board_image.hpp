#pragma once

#include <cstdint>
#include <vector>

#include "firmware/board_order.hpp"
#include "sim/database/board_link.hpp"
#include "sim/database/board_room.hpp"
#include "sim/database/board_writer.hpp"
#include "sim/database/prepared_scene.hpp"

namespace maquette::sim {

/// A board's RAM from which its program can be started, and where things are in it.
struct BoardImage {
  std::vector<unsigned char> ram;
  LinkedProgram program;
  std::uint32_t database;    ///< begins here, behind the program; or the task, when it is shared
  std::uint32_t loaded_end;  ///< what the host loads ends here
  std::uint32_t own_pixels;  ///< begin here, if the board keeps any
  std::uint32_t stack;       ///< what the stack pointer is at the start: the task is the argument
};

/// Writes program, database and task into a board's RAM as ram_layout places them, with numbers of
/// the format. Of the order the line is filled in. Throws std::out_of_range when they do not fit
/// with all else that has its place.
BoardImage board_image(firmware::NumberFormat numbers, const PreparedScene<float>& scene,
                       const firmware::WorkArea<float>& area, const firmware::BoardOrder& order,
                       const BoardRoom& room);

/// The arrays of a scene that are loaded as memory holds them, one behind the other.
std::vector<unsigned char> database_image(const PackedScene<float>& scene,
                                          firmware::NumberFormat numbers);

}  // namespace maquette::sim
