#pragma once

#include <optional>

#include "models/bus/duration.hpp"

namespace maquette::models {

/// Where pixels are kept: in one memory on the bus, or each in the RAM of the board that owns it.
enum class FramePlace { central, boards };

/// The frame memory: geometry, planes, access from the bus.
struct FrameMemoryParameters {
  int width = 768;
  int height = 575;
  int red_bits = 8;
  int green_bits = 8;
  int blue_bits = 8;
  int depth_bits = 0;                 ///< 0: the display has no depth planes
  std::optional<bool> depth_compare;  ///< a pixel replaces no nearer one; not without planes
  std::optional<FramePlace> place;    ///< central where it is not given
  int ports = 1;                      ///< each with a backplane of its own
  Duration access_time{250'000};      ///< data strobe to acknowledge, no video conflict
  bool video_priority = true;         ///< the video reader's slots delay the bus port
  int video_slot_pixels = 16;         ///< pixels fetched by one video slot
  Duration video_slot_time{400'000};  ///< how long a slot keeps the memory
};

[[nodiscard]] inline bool compares_depth(const FrameMemoryParameters& parameters) {
  return parameters.depth_compare.value_or(false);
}

/// Whether boards keep the pixels that they own.
[[nodiscard]] inline bool is_distributed(const FrameMemoryParameters& parameters) {
  switch (parameters.place.value_or(FramePlace::central)) {
    case FramePlace::central:
      return false;
    case FramePlace::boards:
      break;
  }
  return true;
}

/// Whether slots of the video reader delay accesses: those of boards never, since the part of their
/// RAM that is shown has a port of its own.
[[nodiscard]] inline bool has_video_slots(const FrameMemoryParameters& parameters) {
  return parameters.video_priority && !is_distributed(parameters);
}

}  // namespace maquette::models
