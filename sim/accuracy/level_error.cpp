#include "sim/accuracy/level_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/report/compare.hpp"

namespace maquette::sim {

namespace {

TimeError time_error(models::Duration time, models::Duration reference) {
  const models::Duration absolute = time - reference;
  if (reference == models::Duration::zero()) {
    return {absolute, absolute == models::Duration::zero() ? std::optional(0.0) : std::nullopt};
  }
  return {absolute, static_cast<double>(absolute.count()) / static_cast<double>(reference.count())};
}

SimulatedError simulated_error(const SimulatedTimes& times, const SimulatedTimes& reference) {
  SimulatedError error;
  error.frame = time_error(times.frame, reference.frame);
  const bool knows_waits = times.waits.size() == reference.waits.size();
  for (std::size_t board = 0; knows_waits && board < times.waits.size(); ++board) {
    error.waits.push_back(time_error(times.waits[board], reference.waits[board]));
    const TimeError& wait = error.waits.back();
    if (!error.worst_wait ||
        std::abs(wait.absolute.count()) > std::abs(error.worst_wait->absolute.count())) {
      error.worst_wait = wait;
    }
  }
  return error;
}

PictureError picture_error(const models::Picture& picture, const models::Picture& reference) {
  const PictureDifference difference = compare_pictures(reference, picture);
  const auto& [red, green, blue] = difference.mean;
  return {*std::max_element(difference.largest.begin(), difference.largest.end()),
          (red + green + blue) / 3, difference.pixels_off};
}

}  // namespace

LevelError error_of(const LevelOutcome& outcome, const LevelOutcome& reference) {
  LevelError error;
  if (outcome.simulated && reference.simulated) {
    error.simulated = simulated_error(*outcome.simulated, *reference.simulated);
  }
  if (outcome.tiles && reference.tiles) {
    error.tiles = tile_error(*outcome.tiles, *reference.tiles);
  }
  error.picture = picture_error(outcome.picture, reference.picture);
  return error;
}

double magnitude_of(const LevelError& error, ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::picture:
      return error.picture.mean;
    case ErrorMeasure::frame_time:
      break;
  }
  const std::optional<double> relative =
      error.simulated ? error.simulated->frame.relative : std::nullopt;
  return std::abs(relative.value_or(std::numeric_limits<double>::infinity()));
}

}  // namespace maquette::sim
