#pragma once

#include <cstdint>

#include "models/board/pixel_source.hpp"
#include "models/bus/bus_burst.hpp"
#include "models/display/pixel_format.hpp"

namespace maquette::models {

/// Where boards find the frame memory: bus address of its first byte, pixels per row, their bytes.
struct FrameWindow {
  std::uint64_t base;
  int width;
  PixelFormat format;
};

/// The burst with which a board writes pixels into the frame memory.
class PixelWriter {
 public:
  PixelWriter(const FrameWindow& frame, unsigned word_bytes)
      : frame_(frame), word_bytes_(word_bytes) {}

  void clear();
  void append(const SynthesizedPixel& pixel);

  /// Makes the burst one of the pixels since `clear`, of which there is at least one.
  void aim();

  [[nodiscard]] BusBurst& burst() { return burst_; }

 private:
  FrameWindow frame_;
  unsigned word_bytes_;
  BusBurst burst_{tlm::TLM_WRITE_COMMAND};
};

}  // namespace maquette::models
