#pragma once

#include <cstdint>
#include <vector>

#include "models/board/kvm02_parameters.hpp"
#include "models/board/pixel_store.hpp"
#include "models/bus/instant.hpp"
#include "models/display/frame_memory.hpp"

namespace maquette::models {

/// Clocks of the RAM in which a board puts a pixel of its own there.
struct OwnPixelClocks {
  Clocks first_word;
  Clocks second_word;  ///< where depths are compared with that of the pixel which was there
};

/// The pixels that a board owns, in its RAM (paper, [16]). The board answers the addresses of a
/// frame memory itself, for the pixels which are its own.
///
/// Assumptions: a write is one of the RAM, with its wait states and refresh; a depth that is
/// compared is read before; addresses are divided by hardware, as those of an interlace by powers
/// of two are by leaving lines out.
class OwnPixels {
 public:
  /// The display is kept by reference.
  OwnPixels(const PixelStore& store, int board, FrameMemory& display)
      : store_(store), board_(board), display_(display) {}

  [[nodiscard]] OwnPixelClocks clocks(const Kvm02Parameters& parameters) const;

  /// Puts a pixel, as PixelFormat has it written, into the RAM and onto the display. Throws
  /// std::logic_error for another board's.
  void keep(const PixelPosition& position, std::uint32_t written, Instant instant,
            std::vector<unsigned char>& ram) const;

 private:
  PixelStore store_;
  int board_;
  FrameMemory& display_;
};

}  // namespace maquette::models
