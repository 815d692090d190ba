#pragma once

#include <cstdint>
#include <optional>

#include "models/board/allotment_parameters.hpp"
#include "models/board/interlace.hpp"
#include "models/board/pixel_rectangle.hpp"

namespace maquette::models {

/// How the pixels of a zone are cut into units, of which a board takes one after the other:
/// interleaved_pixels: every pixel, in row-major order;
/// interleaved_lines: every row;
/// bands: as many consecutive groups of rows as there are boards, as equal as whole rows allow;
/// tiles: in row-major order (those at the right and the bottom are cut by the zone), each row by
/// row;
/// interlaced: as many as there are boards, each every k-th pixel of every l-th row of the screen
/// (Interlace), row by row.
/// Every pixel has an index, in the order of the units and within each unit; it is what boards ask
/// a pixel source for.
class PixelAllotment {
 public:
  /// Throws std::invalid_argument for no boards, a negative zone or empty tiles, and as
  /// interlace_of.
  PixelAllotment(const AllotmentParameters& parameters, const PixelRectangle& zone, int boards);

  /// The number of units; some bands, and parts of an interlace, may be empty.
  [[nodiscard]] std::int64_t units() const { return units_; }

  /// The number of pixels, which are those of the zone.
  [[nodiscard]] std::int64_t pixels() const { return zone_.pixels(); }

  /// Index of the first pixel of a unit, 0 <= unit <= units(); its pixels end where the next one's
  /// begin.
  [[nodiscard]] std::int64_t first_pixel(std::int64_t unit) const;

  /// Where the pixel with an index stands, 0 <= index < pixels().
  [[nodiscard]] PixelPosition position(std::int64_t index) const;

  /// The index of the pixel at a position of the zone.
  [[nodiscard]] std::int64_t index(const PixelPosition& position) const;

 private:
  [[nodiscard]] PixelPosition in_zone(std::int64_t column, std::int64_t row) const;

  PixelRectangle zone_;
  std::optional<InterlacedPixels> interlaced_;
  bool cut_in_bands_ = false;
  int unit_width_;  // of units other than bands, where the zone does not cut them
  int unit_height_ = 1;
  bool units_are_equal_ = false;  // in pixels, row by row
  std::int64_t units_per_row_;
  std::int64_t units_;
};

}  // namespace maquette::models
