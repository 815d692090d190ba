#pragma once

#include <cstdint>
#include <string_view>

namespace maquette::sim {

/// A time as people write it, in picoseconds: a number with a unit as descriptions have it, or
/// hours and minutes before it or alone, "9 min", "6 min 59 s", "1 h 30 min". Throws
/// std::invalid_argument that says what is wrong and what is allowed.
[[nodiscard]] std::int64_t parse_time(std::string_view text);

}  // namespace maquette::sim
