#pragma once

#include "firmware/board/pixel_output.hpp"

namespace maquette::firmware {

/// Synthesises the pixels of a rectangle row by row, and puts each behind the pixels that wait to
/// be written.
void synthesize_unit(const BoardTask<BoardNumber>& task, const Rectangle& unit, Line& line);

}  // namespace maquette::firmware
