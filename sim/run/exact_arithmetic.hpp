#pragma once

#include "models/board/board_program.hpp"
#include "sim/database/board_link.hpp"

namespace maquette::sim {

/// Has the host execute the routines of the project's arithmetic package for a linked program with
/// FFP numbers. Each call takes exactly the clocks and bus cycles that the package takes on its
/// operands; the elementary functions, which are the program's, call them.
models::HostRoutines exact_arithmetic(const LinkedProgram& program);

}  // namespace maquette::sim
