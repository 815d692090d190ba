#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/database/board_code.hpp"

namespace maquette::sim {

/// The address of what is left out: an odd one, to which no program can go.
inline constexpr std::uint32_t k_left_out = 1;

/// The program of a board, linked for a scene: the pieces that it needs, one behind the other.
struct LinkedProgram {
  const firmware::ProgramCode* code;
  std::uint32_t base;
  std::uint32_t package;  ///< address of the arithmetic package, which is behind the pieces
  std::vector<unsigned char> bytes;
  std::vector<std::uint32_t> addresses;  ///< of each piece, or k_left_out
};

/// Links pieces of a program, from an even address on. Who calls a piece that is left out stops.
LinkedProgram linked_program(std::uint32_t base, const BoardPieces& pieces);

/// Where a board starts: with the conversion of its scene, or without.
std::uint32_t beginning_of(const LinkedProgram& program);

/// Where a function of the linked program begins, or k_left_out.
std::uint32_t address_of(const LinkedProgram& program, std::string_view name);

}  // namespace maquette::sim
