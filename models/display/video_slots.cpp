#include "models/display/video_slots.hpp"

#include <algorithm>
#include <stdexcept>

namespace maquette::models {

namespace {

int checked_slot_pixels(const FrameMemoryParameters& parameters) {
  if (parameters.video_slot_pixels < 1) {
    throw std::invalid_argument("a video slot must fetch at least one pixel");
  }
  return parameters.video_slot_pixels;
}

}  // namespace

VideoSlots::VideoSlots(const VideoTiming& timing, const FrameMemoryParameters& parameters)
    : timing_(timing),
      access_time_(parameters.access_time),
      slot_time_(parameters.video_slot_time),
      slot_period_(timing.pixel_period().multiplied(checked_slot_pixels(parameters))),
      slots_per_line_((timing.width() + parameters.video_slot_pixels - 1) /
                      parameters.video_slot_pixels) {
  if (timing_.blanking() + slot_period_.times(slots_per_line_ - 1) + slot_time_ >
      timing_.line_period().times(1)) {
    throw std::invalid_argument("the last video slot of a line must end within its line");
  }
  // Both gaps are at least as wide as the rounding of their ends to whole picoseconds leaves them.
  const Duration within_line = slot_period_.times(1) - slot_time_;
  const Duration between_lines =
      timing_.line_period().times(1) - slot_period_.times(slots_per_line_ - 1) - slot_time_;
  if (std::min(within_line, between_lines) < access_time_) {
    throw std::invalid_argument("an access to the frame memory never fits between video slots");
  }
}

Instant VideoSlots::clear_of(Instant access, Instant slot_start) const {
  const bool overlaps = access < slot_start + slot_time_ && access + access_time_ > slot_start;
  return overlaps ? slot_start + slot_time_ : access;
}

Instant VideoSlots::earliest_access(Instant instant) const {
  const std::int64_t line = timing_.line_at(instant);
  Instant access = instant;
  if (timing_.is_active(line)) {
    const Instant active = timing_.active_start(line);
    const std::int64_t slot = instant < active ? 0 : slot_period_.index_at(instant - active);
    if (slot < slots_per_line_) {
      access = clear_of(access, active + slot_period_.times(slot));
    }
    if (slot + 1 < slots_per_line_) {
      // Past that slot it fits before the next one; before it, the next one is far.
      return access == instant ? clear_of(access, active + slot_period_.times(slot + 1)) : access;
    }
  }
  if (timing_.is_active(line + 1)) {
    access = clear_of(access, timing_.active_start(line + 1));
  }
  return access;
}

}  // namespace maquette::models
