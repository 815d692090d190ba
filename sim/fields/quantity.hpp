#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/fields/dimension.hpp"

namespace maquette::sim {

/// Reads a number with its unit, such as "8 MHz"; the space between them may be left out. Rounds
/// once, to the nearest double of the stored unit. Throws std::invalid_argument saying what is
/// wrong and which units are allowed.
[[nodiscard]] double parse_quantity(std::string_view text, RealDimension dimension);

/// Reads a whole value exactly: "62.5 ns" is 62500 ps, and "0.1 ps" is an error. Throws
/// std::invalid_argument saying what is wrong and which units are allowed.
[[nodiscard]] std::int64_t parse_quantity(std::string_view text, WholeDimension dimension);

/// The shortest text that reads back to the same value; of equally short ones the one with the
/// largest unit that does not make it begin with "0." or need an
/// exponent.
[[nodiscard]] std::string format_quantity(double value, RealDimension dimension);
[[nodiscard]] std::string format_quantity(std::int64_t value, WholeDimension dimension);

/// The allowed units as a list for people: "Hz, kHz, MHz, GHz"; "none".
[[nodiscard]] std::string unit_list(RealDimension dimension);
[[nodiscard]] std::string unit_list(WholeDimension dimension);

}  // namespace maquette::sim
