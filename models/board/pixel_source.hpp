#pragma once

#include <cstdint>

#include "firmware/arithmetic/work.hpp"

namespace maquette::models {

/// A pixel that a board has synthesised: where it goes, its colour and depth, what it cost.
struct SynthesizedPixel {
  std::uint16_t column;
  std::uint16_t row;
  std::uint16_t depth;  ///< for a frame memory with depth planes
  std::uint32_t rgb;    ///< 0xRRGGBB
  firmware::RayCounts rays;
  firmware::Work work;
};

/// The seam between a board and the firmware: where pixels come from (native firmware, a recorded
/// frame, an instruction-level processor). Pixels do not depend on simulated time, nor on the board
/// that takes them.
class PixelSource {
 public:
  PixelSource() = default;
  PixelSource(const PixelSource&) = delete;
  PixelSource& operator=(const PixelSource&) = delete;
  PixelSource(PixelSource&&) = delete;
  PixelSource& operator=(PixelSource&&) = delete;
  virtual ~PixelSource() = default;

  /// The pixel with an index of the machine's PixelAllotment, valid until the next call. Each is
  /// asked for once, by whichever board takes its unit.
  virtual const SynthesizedPixel& pixel(std::int64_t index) = 0;

  /// What each board spends on preprocessing before its first pixel.
  [[nodiscard]] virtual firmware::Work preprocessing() const = 0;
};

}  // namespace maquette::models
