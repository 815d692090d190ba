#pragma once

#include <cstdint>
#include <vector>

#include "firmware/database.hpp"

namespace maquette::sim {

/// How much of each piece of the board's program (firmware/board_code.hpp) a board holds, in bytes
/// from its beginning; 0 of one that is left out.
using PieceBytes = std::vector<std::uint32_t>;

/// The whole program.
[[nodiscard]] PieceBytes all_pieces();

/// What a board can come to in a scene with these needs: the pieces to which the addresses in its
/// program lead, from its beginning on. Of the table of primitives, the rows behind the last that
/// is needed are left out, so that a further primitive takes nothing from scenes without it.
[[nodiscard]] PieceBytes needed_pieces(const firmware::Needs& needs);

/// All pieces together.
[[nodiscard]] std::int64_t code_bytes(const PieceBytes& pieces);

}  // namespace maquette::sim
