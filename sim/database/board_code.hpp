#pragma once

#include <cstdint>
#include <vector>

#include "firmware/database.hpp"
#include "firmware/program_code.hpp"
#include "models/board/allotment_parameters.hpp"

namespace maquette::sim {

/// The program of a board with numbers of a format.
[[nodiscard]] const firmware::ProgramCode& program_code(firmware::NumberFormat numbers);

/// What of a program a board holds.
struct BoardPieces {
  const firmware::ProgramCode* code;
  std::vector<std::uint32_t> bytes;  ///< of each piece from its beginning; 0 of one left out

  /// Who calls one piece comes to another.
  struct Detour {
    std::uint32_t from;
    std::uint32_t to;
  };
  std::vector<Detour> detours = {};

  /// Where an address of a piece leads.
  [[nodiscard]] std::uint32_t target(std::uint32_t piece) const {
    for (const Detour& detour : detours) {
      piece = detour.from == piece ? detour.to : piece;
    }
    return piece;
  }
};

/// The whole program.
[[nodiscard]] BoardPieces all_pieces(const firmware::ProgramCode& code);

/// What a board can come to in a scene with these needs: the pieces to which the addresses in its
/// program lead, from its beginning on. Of the table of primitives, the rows behind the last that
/// is needed are left out, so that a further primitive takes nothing from scenes without it. Boards
/// of an interlace have its loop over their pixels in place of the others', and in a parallel view
/// the functions that are for one; where a primitive has a conversion they begin with it.
[[nodiscard]] BoardPieces needed_pieces(const firmware::ProgramCode& code,
                                        const firmware::Needs& needs, models::Allotment order = {});

/// All pieces together.
[[nodiscard]] std::int64_t code_bytes(const BoardPieces& pieces);

}  // namespace maquette::sim
