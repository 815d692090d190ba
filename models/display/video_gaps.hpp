#pragma once

#include <algorithm>
#include <cstdint>

#include "models/bus/period.hpp"
#include "models/display/frame_memory_parameters.hpp"

namespace maquette::models {

/// What the video reader's slots leave to others: each at least as wide as the rounding of its ends
/// to whole picoseconds leaves it, negative where slots overlap.
struct VideoGaps {
  Duration within_line;    ///< between two slots of a line
  Duration between_lines;  ///< from the last slot of a line to the first one of the next
  Duration after_last;     ///< from the last slot of a line to the line's end

  /// The longest access that fits between any two slots.
  [[nodiscard]] Duration narrowest() const { return std::min(within_line, between_lines); }
};

/// Of slots of at least one pixel, on lines of `width` pixels.
[[nodiscard]] inline VideoGaps video_gaps(const Period& line, const Period& pixel, int width,
                                          Duration blanking, const FrameMemoryParameters& memory) {
  const Period slot = pixel.multiplied(memory.video_slot_pixels);
  const std::int64_t slots = (width + memory.video_slot_pixels - 1) / memory.video_slot_pixels;
  const Duration between_lines = line.times(1) - slot.times(slots - 1) - memory.video_slot_time;
  return {slot.times(1) - memory.video_slot_time, between_lines, between_lines - blanking};
}

}  // namespace maquette::models
