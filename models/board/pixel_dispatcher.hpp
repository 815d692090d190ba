#pragma once

#include <functional>

#include "models/board/pixel_source.hpp"
#include "models/board/processor.hpp"

namespace maquette::models {

/// What a board lends to whoever has its pixels made.
struct DispatchedBoard {
  Processor& processor;
  std::function<bool()> has_pixel;                     ///< whether it has another one to begin
  std::function<const SynthesizedPixel&()> take;       ///< begins it; valid until the next
  std::function<void(const SynthesizedPixel&)> write;  ///< writes one, as its processor's work
};

/// How a board has its pixels made when it does not do all of them itself, one after the other: has
/// all of them made, in the board's process.
using PixelDispatcher = std::function<void(const DispatchedBoard&)>;

}  // namespace maquette::models
