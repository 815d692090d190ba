#pragma once

#include "models/board/board_program.hpp"
#include "sim/database/board_link.hpp"

namespace maquette::sim {

/// Has the host execute the arithmetic of a linked program, elementary functions included, and
/// count it by operation; the machine's cost table tells what it takes.
models::HostRoutines host_arithmetic(const LinkedProgram& program);

}  // namespace maquette::sim
