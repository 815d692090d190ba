#pragma once

#include <optional>

#include "models/bus/duration.hpp"

namespace maquette::models {

/// The frame memory: geometry, planes, access from the bus.
struct FrameMemoryParameters {
  int width = 768;
  int height = 575;
  int red_bits = 8;
  int green_bits = 8;
  int blue_bits = 8;
  int depth_bits = 0;                 ///< 0: the display has no depth planes
  std::optional<bool> depth_compare;  ///< a pixel replaces no nearer one; not without planes
  int ports = 1;                      ///< each with a backplane of its own
  Duration access_time{250'000};      ///< data strobe to acknowledge, no video conflict
  bool video_priority = true;         ///< the video reader's slots delay the bus port
  int video_slot_pixels = 16;         ///< pixels fetched by one video slot
  Duration video_slot_time{400'000};  ///< how long a slot keeps the memory
};

[[nodiscard]] inline bool compares_depth(const FrameMemoryParameters& parameters) {
  return parameters.depth_compare.value_or(false);
}

}  // namespace maquette::models
