#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "models/board/kvm02_parameters.hpp"
#include "models/bus/bus_master_place.hpp"
#include "models/unit/unit_kind.hpp"

namespace maquette::models {

/// Which unit of its kind an errand goes to: the one with the least before it, or one that its
/// pixel's place on the screen tells.
enum class UnitChoice { first_come, by_pixel };

/// The units of one kind. What is not said of them is as of the boards.
struct FunctionUnitParameters {
  int number = 0;  ///< of units; none: the boards do it
  int queue = 4;   ///< places of each for errands that wait or are on the bus
  UnitChoice choice = UnitChoice::first_come;
  std::optional<double> clock_hz;        ///< of the unit's own work; the boards' without
  std::optional<ArithmeticCosts> costs;  ///< of the unit's own work; the boards' without
  int request_level = 1;                 ///< on the bus, behind the boards of that level
  Duration access_time{625'000};         ///< of its mailbox, and of its RAM, seen from the bus
  std::int64_t ram_bytes = std::int64_t{128} * 1024;
};

/// The function units of a machine, by kind, and how boards use them.
struct UnitsParameters {
  std::array<FunctionUnitParameters, k_unit_kind_count> kinds;
  int in_flight = 1;  ///< pixels that a board has begun and not yet written, at most
};

inline bool has_units(const UnitsParameters& units) {
  return std::any_of(units.kinds.begin(), units.kinds.end(),
                     [](const FunctionUnitParameters& kind) { return kind.number > 0; });
}

/// Where a unit sits on the bus, the units of all kinds being numbered in their order.
inline BusMasterPlace unit_place(const FunctionUnitParameters& kind, std::size_t boards,
                                 std::size_t unit) {
  return {kind.request_level, static_cast<int>(boards + unit)};
}

/// Pixels in flight on all boards together with which nothing can deadlock.
///
/// An errand that has been served keeps its unit until it has a place with the next one; boards
/// take back whatever comes. Were nothing to go on, each errand would stand before a kind, or a
/// unit where pixels choose it, that is full: all places taken, and every unit kept by an errand
/// that waits for another kind, which is full as well. So two of different kinds would be full, and
/// fewer errands than fill any two of them do not deadlock. There is one errand to a pixel in
/// flight.
inline std::int64_t most_pixels_in_flight(const UnitsParameters& units) {
  constexpr std::int64_t k_any = std::numeric_limits<std::int64_t>::max();
  std::int64_t least = k_any;
  std::int64_t second = k_any;
  for (const FunctionUnitParameters& kind : units.kinds) {
    if (kind.number > 0) {
      const std::int64_t one = std::int64_t{kind.queue} + 1;
      const std::int64_t full = kind.choice == UnitChoice::by_pixel ? one : one * kind.number;
      second = std::min(second, std::max(least, full));
      least = std::min(least, full);
    }
  }
  return second == k_any ? k_any : least + second - 1;
}

}  // namespace maquette::models
