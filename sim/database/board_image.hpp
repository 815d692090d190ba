#pragma once

#include <cstdint>
#include <vector>

#include "firmware/board_order.hpp"
#include "sim/database/board_link.hpp"
#include "sim/database/board_writer.hpp"

namespace maquette::sim {

/// What a board's RAM has room for besides the program and the scene.
struct BoardRoom {
  std::uint32_t ram_bytes;
  std::uint32_t system_bytes;  ///< at the bottom
  std::uint32_t crossings;
  std::uint32_t waiting_rays;
  std::uint32_t line_pixels;  ///< that are kept until they are written together
  std::uint32_t stack_bytes;  ///< at the top
  std::uint32_t
      package_bytes;  ///< of the arithmetic package, where it is larger than the program's
};

/// A board's RAM from which its program can be started, and where things are in it.
struct BoardImage {
  std::vector<unsigned char> ram;
  LinkedProgram program;
  std::uint32_t database;    ///< begins here, behind the program
  std::uint32_t loaded_end;  ///< program and database end here
  std::uint32_t stack;       ///< what the stack pointer is at the start: the task is the argument
};

/// Lays out program, database with the board's task, what preprocessing makes of it, work area and
/// line of pixels, in this order; the first two are written, with numbers of the format. Of the
/// order the line is filled in. Throws std::out_of_range when they and the stack do not fit.
BoardImage board_image(firmware::NumberFormat numbers, const firmware::Frame<float>& frame,
                       const firmware::WorkArea<float>& area, const firmware::BoardOrder& order,
                       const BoardRoom& room);

}  // namespace maquette::sim
