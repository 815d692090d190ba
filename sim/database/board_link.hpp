#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "firmware/program_code.hpp"

namespace maquette::sim {

/// The program of a board with numbers of a format.
const firmware::ProgramCode& program_code(firmware::NumberFormat numbers);

/// The program of a board, linked for a scene: the pieces that it needs, one behind the other.
struct LinkedProgram {
  const firmware::ProgramCode* code;
  std::uint32_t base;
  std::uint32_t package;  ///< address of the arithmetic package, which is behind the pieces
  std::vector<unsigned char> bytes;
  std::vector<std::uint32_t> addresses;  ///< of each piece; 0 of one that is left out
};

/// Links the pieces of a program for which `is_needed` holds, from an even address on. Who calls a
/// piece that is left out stops at an odd address.
LinkedProgram linked_program(const firmware::ProgramCode& code, std::uint32_t base,
                             const std::function<bool(const firmware::CodePiece&)>& is_needed);

/// Where a function of the linked program begins. Throws std::out_of_range when it has none of this
/// name.
std::uint32_t address_of(const LinkedProgram& program, std::string_view name);

}  // namespace maquette::sim
