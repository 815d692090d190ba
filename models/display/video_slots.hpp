#pragma once

#include <optional>

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
  /// A line, and when those show pixels that have slots near it.
  struct Line {
    Instant begin{};
    Instant next_begin{};
    std::optional<Instant> active;       // of this line, if it shows a row
    std::optional<Instant> next_active;  // of the next
  };

  [[nodiscard]] Line line_at(Instant instant) const;
  [[nodiscard]] Instant clear_of(Instant access, Instant slot_start) const;

  VideoTiming timing_;
  Duration access_time_;
  Duration slot_time_;
  Period slot_period_;
  std::int64_t slots_per_line_;
  mutable Line
      line_;  // of the last access: the next one, another word of its pixel, is mostly in it
};

}  // namespace maquette::models
