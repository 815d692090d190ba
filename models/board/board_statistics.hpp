#pragma once

#include <cstdint>
#include <optional>

#include "models/board/work_totals.hpp"
#include "models/bus/instant.hpp"

namespace maquette::models {

/// What a board, or a function unit, did with its time. The five states sum to the time from the
/// start of the frame to the instant for which they were asked.
struct BoardStatistics {
  Duration compute{};        ///< preprocessing, synthesis, and its own clocks between two words
  Duration wait_grant{};     ///< bus requested, not granted
  Duration transfer{};       ///< bus granted, until released
  Duration wait_unit{};      ///< nothing to do until a function unit has done something
  Duration idle{};           ///< after its last pixel; of a unit: no errand
  Duration preprocessing{};  ///< of `compute`
  Duration working{};        ///< of `compute`: work of the preprocessing and of its pixels
  Duration longest_wait{};   ///< for one grant
  Instant longest_wait_request{};
  std::optional<Instant> finished;  ///< end of its last work, when it has ended
  std::int64_t pixels = 0;
  std::int64_t words = 0;
  Duration claiming{};      ///< of the states: for units, from the first try to the last step
  std::int64_t claims = 0;  ///< the last one of a board finds no unit left
  std::int64_t database_words = 0;  ///< of `words`: read from a shared database
  std::int64_t failed_tries = 0;    ///< test-and-set cycles that found the lock taken
  WorkTotals work;                  ///< of its pixels
};

}  // namespace maquette::models
