#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/board/allotment.hpp"
#include "models/board/pixel_source.hpp"

/// A pixel source for tests: an allotted zone with work and colour given by functions.
namespace maquette::models::traffic {

class AllottedPixels : public PixelSource {
 public:
  using Colour = std::function<std::uint32_t(PixelPosition)>;
  using Glue = std::function<std::uint32_t(PixelPosition)>;

  /// Each pixel costs `glue(position)` branches.
  AllottedPixels(const PixelAllotment& allotment, Colour colour, Glue glue,
                 std::uint32_t preprocessing_branches)
      : allotment_(allotment), colour_(std::move(colour)), glue_(std::move(glue)) {
    preprocessing_[firmware::Operation::node] = preprocessing_branches;
  }

  const SynthesizedPixel& pixel(std::int64_t index) override {
    const PixelPosition position = allotment_.position(index);
    pixel_ = {static_cast<std::uint16_t>(position.column),
              static_cast<std::uint16_t>(position.row),
              0,
              colour_(position),
              {1, 2, 3, 4},
              {}};
    pixel_.work[firmware::Operation::node] = glue_(position);
    return pixel_;
  }

  [[nodiscard]] firmware::Work preprocessing() const override { return preprocessing_; }

 private:
  SynthesizedPixel pixel_{};
  PixelAllotment allotment_;
  Colour colour_;
  Glue glue_;
  firmware::Work preprocessing_{};
};

/// A board on which a branch costs one clock of 8 MHz and nothing else does; no refresh.
inline Kvm02Parameters plain_board() {
  Kvm02Parameters board;
  board.refresh_period = Duration::zero();
  board.arithmetic.operations[static_cast<std::size_t>(firmware::Operation::node)].clocks = 1;
  return board;
}

/// `count` boards, the first at the highest place; more than five share levels.
inline std::vector<BusMasterPlace> places(int count) {
  std::vector<BusMasterPlace> places;
  for (int board = 0; board < count; ++board) {
    places.push_back({3 - board % 4, board / 4});
  }
  return places;
}

}  // namespace maquette::models::traffic
