#pragma once

#include <cstdint>

#include "models/display/frame_memory_parameters.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// The slots of the video reader, one after the other.
class SlotWalk {
 public:
  SlotWalk(const VideoTiming& timing, const FrameMemoryParameters& parameters);

  /// Goes to the first slot that ends after an instant; next, to the one behind.
  void enter(Instant instant);
  void next();

  /// When the slot has the memory.
  [[nodiscard]] Instant begin() const;
  [[nodiscard]] Instant end() const { return begin() + slot_time_; }

  /// From when on an access that begins would not end before the slot begins.
  [[nodiscard]] Instant too_late() const { return begin() - access_time_ + k_tick; }

 private:
  VideoTiming timing_;
  Duration access_time_;
  Duration slot_time_;
  Period distance_;
  std::int64_t slots_per_line_;
  std::int64_t line_ = 0;  // from instant 0
  std::int64_t slot_ = 0;  // of the line
};

}  // namespace maquette::models
