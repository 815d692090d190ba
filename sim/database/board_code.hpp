#pragma once

#include <cstdint>
#include <string_view>

#include "firmware/database.hpp"

namespace maquette::sim {

/// The first primitives of the table, whose rows of it stand in every board's program. A row behind
/// them is there only as far as the scene needs it, so that a further primitive takes nothing from
/// the scenes that do without it.
inline constexpr int k_resident_primitives = 10;

/// Code of the firmware as compiled for the 68000, in bytes.
struct BoardCode {
  std::int64_t needed_bytes;    ///< what a scene's needs make a board hold
  std::int64_t left_out_bytes;  ///< what it can do without
};

/// Whether a scene with these needs runs a function of the board's program, given by its name. What
/// nobody calls in particular, every scene needs.
bool is_needed(std::string_view function, const firmware::Needs& needs);

BoardCode board_code_of(const firmware::Needs& needs);

/// Stack of the deepest chain of calls, for a tree with so many composites on its longest way down
/// and the primitives that are needed;
/// from the compiler's stack usage, plus a return address per call.
std::int64_t board_stack_bytes(int tree_height, const firmware::Needs& needs);

}  // namespace maquette::sim
