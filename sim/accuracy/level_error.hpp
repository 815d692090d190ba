#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "models/bus/duration.hpp"
#include "sim/accuracy/ladder.hpp"
#include "sim/accuracy/level_outcome.hpp"
#include "sim/accuracy/tile_error.hpp"

namespace maquette::sim {

/// How far a simulated time is from the reference's.
struct TimeError {
  models::Duration absolute{};     ///< less the reference's, with its sign
  std::optional<double> relative;  ///< to the reference's; nothing when that is zero and this not
};

/// How far the simulated times of a level are from those of its reference.
struct SimulatedError {
  TimeError frame;
  std::vector<TimeError> waits;         ///< by board, where both levels know them
  std::optional<TimeError> worst_wait;  ///< of the board where it is largest
};

/// How far the picture of a level is from its reference's; channels have levels 0 to 255.
struct PictureError {
  int largest = 0;              ///< of any channel of any pixel
  double mean = 0;              ///< over pixels and channels
  std::int64_t pixels_off = 0;  ///< with a channel that is off by more than one level
};

struct LevelError {
  std::optional<SimulatedError> simulated;  ///< where both levels simulate
  PictureError picture;
  std::optional<TileError> tiles;  ///< where both levels time them
};

/// The errors of an outcome, for a reference with as many boards and pixels.
[[nodiscard]] LevelError error_of(const LevelOutcome& outcome, const LevelOutcome& reference);

/// The one number, zero or above, that a ladder judges its levels by; infinite when it has none.
[[nodiscard]] double magnitude_of(const LevelError& error, ErrorMeasure measure);

}  // namespace maquette::sim
