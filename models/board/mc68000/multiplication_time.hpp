#pragma once

#include <cstdint>

namespace maquette::models::mc68000 {

/// Cycles that MULU takes beyond its 38: two for each bit of the source that is set (table 8-4).
unsigned unsigned_multiplication_cycles(std::uint16_t source);

/// Cycles that MULS takes beyond its 38: two for each change between neighbouring bits of the
/// source with a zero appended below (table 8-4).
unsigned signed_multiplication_cycles(std::uint16_t source);

/// All cycles of DIVU, operand fetches left out. The manual gives a maximum; this follows the
/// microcode's restoring division step by step, as J. Cwik has analysed it.
unsigned unsigned_division_cycles(std::uint32_t dividend, std::uint16_t divisor);

/// All cycles of DIVS, operand fetches left out; likewise.
unsigned signed_division_cycles(std::int32_t dividend, std::int16_t divisor);

}  // namespace maquette::models::mc68000
