#pragma once

#include <optional>

#include "models/bus/duration.hpp"

namespace maquette::models {

/// The units in which the boards take the pixels of the useful zone, and their order.
enum class Allotment { interleaved_pixels, interleaved_lines, bands, tiles, interlaced };

/// How boards come to their units: every n-th one, or the next one of a counter that they share.
enum class Assignment { fixed, on_demand };

/// Whether boards claim each unit that they take.
constexpr bool is_claimed(Assignment assignment) {
  switch (assignment) {
    case Assignment::fixed:
      return false;
    case Assignment::on_demand:
      break;
  }
  return true;
}

/// How a board claims a unit: TAS on the counter's lock until it is free, MOVE.L of the counter,
/// ADDQ.L, MOVE.L back, MOVE.B that clears the lock. Processor clocks besides the bus accesses.
struct ClaimParameters {
  Clocks modify_clocks = 2;   ///< within the bus cycle of TAS, between its read and its write
  Clocks spin_clocks = 28;    ///< from a TAS that failed to the next, times the number of boards
  Clocks read_clocks = 16;    ///< from the TAS that succeeded to the counter's read
  Clocks update_clocks = 22;  ///< from there to the counter's write
  Clocks unlock_clocks = 6;   ///< from there to the write that clears the lock
  Clocks finish_clocks = 24;  ///< from there to the first pixel
};

/// How the pixels of the useful zone are given to the boards.
struct AllotmentParameters {
  Allotment order = Allotment::interleaved_pixels;
  int tile_width = 32;
  int tile_height = 32;
  std::optional<int> columns;  ///< of an interlace; see interlace_of where they are not given
  std::optional<int> lines;
  Assignment assignment = Assignment::fixed;
  ClaimParameters claim;
};

}  // namespace maquette::models
