#pragma once

#include <cstdint>

#include "firmware/database.hpp"

namespace maquette::sim {

/// Code of the firmware as compiled for the 68000, in bytes.
struct BoardCode {
  std::int64_t needed_bytes;    ///< what a scene's needs make a board hold
  std::int64_t left_out_bytes;  ///< what it can do without
};

BoardCode board_code_of(const firmware::Needs& needs);

/// Stack of the deepest chain of calls, for a tree with so many composites on its longest way down
/// and the primitives that are needed;
/// from the compiler's stack usage, plus a return address per call.
std::int64_t board_stack_bytes(int tree_height, const firmware::Needs& needs);

}  // namespace maquette::sim
