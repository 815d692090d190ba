#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maquette::sim {

/// What a real value measures, and so the units that it may carry.
enum class RealDimension {
  number,     ///< no unit
  fraction,   ///< no unit, or %
  frequency,  ///< Hz kHz MHz GHz; stored in Hz
  angle       ///< deg
};

/// What a whole value measures, and so the units that it must carry.
enum class WholeDimension {
  count,   ///< no unit
  time,    ///< ps ns us ms s; stored in ps
  memory,  ///< B KiB MiB; stored in bytes
  clocks,
  bits,
  pixels,
  lines
};

/// Whether the units of a dimension are powers of ten of one another.
constexpr bool is_decimal(WholeDimension dimension) {
  switch (dimension) {
    case WholeDimension::count:
    case WholeDimension::memory:
    case WholeDimension::clocks:
    case WholeDimension::bits:
    case WholeDimension::pixels:
    case WholeDimension::lines:
      return false;
    case WholeDimension::time:
      break;
  }
  return true;
}

/// A unit of a real dimension: 10^decimal_exponent of the stored one.
struct RealUnit {
  std::string_view name;
  int decimal_exponent;
};

/// A unit of a whole dimension: `factor` times the stored one; its name with 1, if that differs.
struct WholeUnit {
  std::string_view name;
  std::int64_t factor;
  std::string_view singular;
};

/// The units of a dimension, the smallest first. An empty name stands for "no unit".
[[nodiscard]] const std::vector<RealUnit>& units(RealDimension dimension);
[[nodiscard]] const std::vector<WholeUnit>& units(WholeDimension dimension);

}  // namespace maquette::sim
