#pragma once

#include "models/display/frame_memory_parameters.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// The fixed slots in which the video reader fetches pixels: on a line that shows a row, one slot
/// of video_slot_time begins every video_slot_pixels pixel clocks, from the first active pixel on.
class VideoSlots {
 public:
  /// Slots that leave room for accesses of `access_time` between any two of them. Throws
  /// std::invalid_argument when they do not.
  VideoSlots(const VideoTiming& timing, const FrameMemoryParameters& parameters);

  /// The earliest start from `instant` on of an access that lies wholly outside the slots.
  [[nodiscard]] Instant earliest_access(Instant instant) const;

 private:
  [[nodiscard]] Instant clear_of(Instant access, Instant slot_start) const;

  VideoTiming timing_;
  Duration access_time_;
  Duration slot_time_;
  Period slot_period_;
  std::int64_t slots_per_line_;
};

}  // namespace maquette::models
