#pragma once

#include <cstdint>
#include <optional>

#include "models/board/allotment.hpp"
#include "models/board/allotment_parameters.hpp"

namespace maquette::models {

/// Which units of the allotment a board takes: first, first + step, first + 2 step, ..., or those
/// that it claims.
struct BoardShare {
  const PixelAllotment& allotment;
  std::int64_t first;
  std::int64_t step;  ///< the number of boards
  std::optional<ClaimParameters> claim;
};

/// A board's way through its share, pixel by pixel.
class ShareCursor {
 public:
  /// The allotment of the share is kept by reference.
  explicit ShareCursor(const BoardShare& share) : share_(share) {}

  /// Goes to the first pixel of a unit; false behind the last unit.
  [[nodiscard]] bool enter(std::int64_t unit) {
    if (unit >= share_.allotment.units()) {
      return false;
    }
    unit_ = unit;
    next_ = share_.allotment.first_pixel(unit);
    unit_end_ = share_.allotment.first_pixel(unit + 1);
    return true;
  }

  /// Whether there is another pixel without claiming one; goes to it.
  [[nodiscard]] bool has_pixel() {
    while (next_ == unit_end_) {
      if (share_.claim || !enter(unit_ + share_.step)) {
        return false;
      }
    }
    return true;
  }

  /// Takes that pixel: its index in the allotment.
  [[nodiscard]] std::int64_t take() { return next_++; }

  /// The row of that pixel.
  [[nodiscard]] int row() const { return share_.allotment.position(next_).row; }

 private:
  BoardShare share_;
  std::int64_t unit_ = 0;
  std::int64_t next_ = 0;
  std::int64_t unit_end_ = 0;
};

}  // namespace maquette::models
