#include "models/display/video_slots.hpp"

#include <stdexcept>

#include "models/display/video_gaps.hpp"

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
  const VideoGaps gaps = video_gaps(timing.line_period(), timing.pixel_period(), timing.width(),
                                    timing.blanking(), parameters);
  if (gaps.after_last < Duration::zero()) {
    throw std::invalid_argument("the last video slot of a line must end within its line");
  }
  if (gaps.narrowest() < access_time_) {
    throw std::invalid_argument("an access to the frame memory never fits between video slots");
  }
}

Instant VideoSlots::clear_of(Instant access, Instant slot_start) const {
  const bool overlaps = access < slot_start + slot_time_ && access + access_time_ > slot_start;
  return overlaps ? slot_start + slot_time_ : access;
}

VideoSlots::Line VideoSlots::line_at(Instant instant) const {
  const std::int64_t number = timing_.line_at(instant);
  const auto active = [this](std::int64_t line) {
    return timing_.is_active(line) ? std::optional(timing_.active_start(line)) : std::nullopt;
  };
  return {timing_.line_period().times(number), timing_.line_period().times(number + 1),
          active(number), active(number + 1)};
}

Instant VideoSlots::earliest_access(Instant instant) const {
  if (instant < line_.begin || instant >= line_.next_begin) {
    line_ = line_at(instant);
  }
  Instant access = instant;
  if (line_.active) {
    const Instant active = *line_.active;
    const std::int64_t slot = instant < active ? 0 : slot_period_.index_at(instant - active);
    if (slot < slots_per_line_) {
      access = clear_of(access, active + slot_period_.times(slot));
    }
    if (slot + 1 < slots_per_line_) {
      // Past that slot it fits before the next one; before it, the next one is far.
      return access == instant ? clear_of(access, active + slot_period_.times(slot + 1)) : access;
    }
  }
  if (line_.next_active) {
    access = clear_of(access, *line_.next_active);
  }
  return access;
}

}  // namespace maquette::models
