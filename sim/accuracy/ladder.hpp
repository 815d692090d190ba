#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace maquette::sim {

/// How a level computes the scene: a whole simulation, with pixels that the native firmware counts,
/// with recorded ones, or with boards that execute their program; or the picture alone by the
/// firmware over a number type.
enum class LevelKind { simulation, recorded, executed, float_picture, double_picture };

/// One way of computing a scene.
struct Level {
  std::string name;
  std::vector<std::string> overrides;  ///< `path=value`, after the user's own
  LevelKind kind = LevelKind::simulation;
  int share = 0;  ///< one in so many pixels is timed, and executed by `executed`; 0: none
};

/// What counts as the error of a ladder's levels: the relative difference of the frame time, or the
/// mean difference of the picture's channels in levels of 255.
enum class ErrorMeasure { frame_time, picture };

/// Whether the simulated time can be what an error is weighed against.
constexpr bool is_apart_from_time(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::frame_time:
      return false;
    case ErrorMeasure::picture:
      break;
  }
  return true;
}

/// A choice between error and run time: levels that differ in one thing, and which of them the
/// others are held against. A ladder is one entry in ladders_of and knows nothing of the others, so
/// a stronger reference is one more level in front.
struct Ladder {
  std::string name;
  std::string varies;  ///< in one sentence
  ErrorMeasure measure = ErrorMeasure::picture;
  std::vector<Level> levels;
  std::size_t reference = 0;  ///< the number of the level that is taken as exact

  [[nodiscard]] const std::string& reference_name() const { return levels[reference].name; }
};

}  // namespace maquette::sim
