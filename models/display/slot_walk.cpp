#include "models/display/slot_walk.hpp"

#include <algorithm>

namespace maquette::models {

SlotWalk::SlotWalk(const VideoTiming& timing, const FrameMemoryParameters& parameters)
    : timing_(timing),
      access_time_(parameters.access_time),
      slot_time_(parameters.video_slot_time),
      distance_(timing.pixel_period().multiplied(parameters.video_slot_pixels)),
      slots_per_line_((timing.width() - 1) / parameters.video_slot_pixels + 1) {
  enter(Instant{0});
}

void SlotWalk::enter(Instant instant) {
  line_ = std::max<std::int64_t>(timing_.line_at(instant) - 1, 0);
  slot_ = 0;
  while (!timing_.is_active(line_)) {
    ++line_;
  }
  while (end() <= instant) {
    next();
  }
}

void SlotWalk::next() {
  ++slot_;
  if (slot_ == slots_per_line_) {
    slot_ = 0;
    do {
      ++line_;
    } while (!timing_.is_active(line_));
  }
}

Instant SlotWalk::begin() const { return timing_.active_start(line_) + distance_.times(slot_); }

}  // namespace maquette::models
