#pragma once

#include <cstdint>

#include "sim/database/board_code.hpp"

namespace maquette::sim {

/// Stack of the deepest chain of calls in a board's program, in bytes: what the compiler says of
/// each function, and return addresses, along the addresses in the program. A function that calls
/// itself stands there as often as the primitive that it belongs to says; those that walk the
/// object tree, as often as the tree has levels. `tree_height` counts composites on the longest way
/// down. Assumption: routines in assembler take at most 16 bytes.
[[nodiscard]] std::int64_t board_stack_bytes(const BoardPieces& pieces, int tree_height);

}  // namespace maquette::sim
