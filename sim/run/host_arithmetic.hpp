#pragma once

#include <cstdint>

#include "models/board/board_program.hpp"

namespace maquette::sim {

/// Has the host execute the routines of the arithmetic package that lies at an address of a board's
/// RAM, and count them by operation; the machine's cost table tells what they take.
models::HostRoutines host_arithmetic(std::uint32_t package);

}  // namespace maquette::sim
