#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "models/board/pixel_rectangle.hpp"
#include "models/bus/duration.hpp"

namespace maquette::models {

/// What a processor has done with its time.
struct ProcessorTime {
  Duration compute{};
  Duration wait{};      ///< bus requested, not granted
  Duration transfer{};  ///< bus granted, until released

  [[nodiscard]] Duration sum() const { return compute + wait + transfer; }
};

constexpr ProcessorTime operator-(const ProcessorTime& a, const ProcessorTime& b) {
  return {a.compute - b.compute, a.wait - b.wait, a.transfer - b.transfer};
}

/// A pixel, the board that wrote it, and what that board's time since its pixel before, or since
/// its preprocessing, went into.
struct PixelTime {
  PixelPosition position{};
  int board = 0;
  ProcessorTime spent;
};

using PixelObserver = std::function<void(const PixelTime&)>;

/// Tells apart what the pixels of a board took, for whoever observes them. All that it tells sums
/// to what the board's processor did between its preprocessing and its last pixel.
///
/// Assumption: pixels that are written together share what their writing took in equal parts.
class PixelMeter {
 public:
  PixelMeter(int board, PixelObserver observer) : board_(board), observer_(std::move(observer)) {}

  /// The first pixel begins.
  void begin(const ProcessorTime& now) { last_ = now; }

  /// A pixel is computed, not yet written.
  void compute(const PixelPosition& position, const ProcessorTime& now);

  /// All that were computed are written.
  void write(const ProcessorTime& now);

 private:
  int board_;
  PixelObserver observer_;
  ProcessorTime last_;
  std::vector<PixelTime> computed_;
};

}  // namespace maquette::models
