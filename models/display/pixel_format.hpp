#pragma once

#include <cstdint>

#include "models/display/frame_memory_parameters.hpp"

namespace maquette::models {

/// How a pixel stands in its four bytes of the frame memory, the first of which is the highest of a
/// 32-bit word.
///
/// Without depth planes: red, green, blue, and one byte that does not exist (written to no effect,
/// read as zero); a plane of n bits keeps the top n of a component's 8. With depth planes: a 16-bit
/// word of the top bits of red, green and blue side by side, right-aligned, then one of the depth,
/// of which n planes keep the top n bits. Assumption: that is how the display of the paper's
/// section VI, 16 bits of colour and 16 of depth, took them.
class PixelFormat {
 public:
  /// Throws std::invalid_argument for colour planes outside 1..8 bits, depth planes outside 0..16,
  /// or depth planes beside more than 16 of colour.
  explicit PixelFormat(const FrameMemoryParameters& parameters);

  /// The bytes of a pixel as a board writes them. `rgb` is 0xRRGGBB.
  [[nodiscard]] std::uint32_t written(std::uint32_t rgb, std::uint16_t depth) const;

  /// The bits that planes keep.
  [[nodiscard]] std::uint32_t kept() const { return kept_; }

  /// The colour of kept bytes as 0xRRGGBB, full code shown as full scale.
  [[nodiscard]] std::uint32_t colour(std::uint32_t bytes) const;

  /// The depth of kept bytes; 0 without depth planes.
  [[nodiscard]] std::uint16_t depth(std::uint32_t bytes) const;

 private:
  /// Where a component's planes are in the bytes.
  struct Component {
    int bits;
    int shift;
  };

  Component red_{};
  Component green_{};
  Component blue_{};
  bool has_depth_ = false;
  bool shows_codes_ = false;  // all 24 planes of colour, whose codes are what is shown
  std::uint32_t kept_ = 0;
};

}  // namespace maquette::models
