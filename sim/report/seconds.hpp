#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "models/bus/duration.hpp"

namespace maquette::sim {

/// A duration in seconds, to the nearest double: for shares and rates, never for results that must
/// be exact.
inline double in_seconds(models::Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// A duration as an exact decimal number of seconds: the integer count of picoseconds with the
/// point moved by twelve places and closing zeros left out, so no binary rounding takes place.
/// Examples: "0", "0.000000000001", "422.5".
std::string format_seconds(models::Duration duration);

/// The duration that a decimal number of seconds with at most twelve decimals stands for, without
/// rounding; nothing when the text is another one, or out of range.
std::optional<models::Duration> parse_seconds(std::string_view text);

/// A duration for the eye: "7 min 02.5 s", "1.25 s", "312 ms", "2.5 us"; about three digits.
std::string readable_duration(models::Duration duration);

}  // namespace maquette::sim
