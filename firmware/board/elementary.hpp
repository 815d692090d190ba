#pragma once

#include <cstdint>

#include "firmware/arithmetic/real.hpp"

/// Functions of a board's numbers. Which format they have, BoardNumber, is told to the compiler:
/// tools/board_code includes a header before each source, ffp.hpp or ieee_single.hpp.
namespace maquette::firmware {

template <>
inline BoardNumber from_integer<BoardNumber>(std::int32_t integer) {
  register std::int32_t value __asm__("d7") = integer;
  __asm__("jsr arithmetic_from_integer" : "+d"(value) : : "d3", "d4", "d5", "cc");
  return BoardNumber::of_bits(static_cast<std::uint32_t>(value));
}

/// The elementary functions are the firmware's own. They have names by which a simulator finds
/// them, since another arithmetic package has its own, at another cost.
BoardNumber exponential(BoardNumber x) __asm__("arithmetic_exponential");
BoardNumber power(BoardNumber base, BoardNumber exponent) __asm__("arithmetic_power");
BoardNumber arc_cosine(BoardNumber cosine) __asm__("arithmetic_arc_cosine");

}  // namespace maquette::firmware
