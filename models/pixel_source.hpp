#pragma once

#include <cstdint>

#include "firmware/work.hpp"

namespace maquette::models {

/// A pixel that a board has synthesised: where it goes, its colour, what it cost.
struct SynthesizedPixel {
  std::uint16_t column;
  std::uint16_t row;
  std::uint32_t rgb;  ///< 0xRRGGBB
  firmware::RayCounts rays;
  firmware::Work work;
};

/// The seam between a board and the firmware: where a board's pixels come from (native firmware, a
/// recorded frame, an instruction-level processor). Pixels do not depend on simulated time.
class PixelSource {
 public:
  PixelSource() = default;
  PixelSource(const PixelSource&) = delete;
  PixelSource& operator=(const PixelSource&) = delete;
  PixelSource(PixelSource&&) = delete;
  PixelSource& operator=(PixelSource&&) = delete;
  virtual ~PixelSource() = default;

  /// The next pixel of `board` in the order of its allotment; null after its last one. The pixel
  /// stays valid until the board's next call.
  virtual const SynthesizedPixel* next(int board) = 0;

  /// What each board spends on preprocessing before its first pixel.
  [[nodiscard]] virtual firmware::Work preprocessing() const = 0;
};

}  // namespace maquette::models
