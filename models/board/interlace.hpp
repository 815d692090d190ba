#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "models/board/allotment_parameters.hpp"
#include "models/board/pixel_rectangle.hpp"

namespace maquette::models {

/// The two-dimensional interlace of Fuchs and Johnson (paper, [15] and [16]): each board has every
/// columns-th pixel of every lines-th row of the screen, so that of any columns x lines pixels side
/// by side each one is another board's.
struct Interlace {
  int columns;
  int lines;

  /// The board that a pixel of the screen belongs to, wherever the useful zone is.
  [[nodiscard]] int board_of(const PixelPosition& position) const {
    return position.column % columns + columns * (position.row % lines);
  }
};

/// The interlace of as many pixels as there are boards. Where columns are not given they are what
/// is left for the lines that are; where neither is, the smallest divisor of the number of boards
/// whose square is not below it (4 boards: 2 x 2; 8: 4 x 2; 7: 7 x 1). Throws std::invalid_argument
/// when columns times lines cannot be the number of boards.
[[nodiscard]] inline Interlace interlace_of(const AllotmentParameters& parameters, int boards) {
  const auto rest = [boards](int part) { return part < 1 ? 0 : boards / part; };
  int columns = 1;
  while (columns * columns < boards || boards % columns != 0) {
    ++columns;
  }
  columns = parameters.columns.value_or(parameters.lines ? rest(*parameters.lines) : columns);
  const Interlace interlace{columns, parameters.lines.value_or(rest(columns))};
  if (interlace.columns < 1 || interlace.lines < 1 ||
      static_cast<std::int64_t>(interlace.columns) * interlace.lines != boards) {
    throw std::invalid_argument("columns times lines of an interlace are the number of boards");
  }
  return interlace;
}

/// The pixels of a zone in an interlace: those of board 0, then those of board 1 and so on, each
/// row by row.
class InterlacedPixels {
 public:
  InterlacedPixels(const Interlace& interlace, const PixelRectangle& zone);

  /// As the functions of PixelAllotment; a unit is what a board has.
  [[nodiscard]] std::int64_t units() const {
    return static_cast<std::int64_t>(first_pixels_.size()) - 1;
  }
  [[nodiscard]] std::int64_t first_pixel(std::int64_t unit) const {
    return first_pixels_[static_cast<std::size_t>(unit)];
  }
  [[nodiscard]] PixelPosition position(std::int64_t index) const;
  [[nodiscard]] std::int64_t index(const PixelPosition& position) const;

 private:
  /// Numbers at equal distances within a side of the zone.
  struct Steps {
    int first;
    int count;
  };

  [[nodiscard]] static Steps steps(int begin, int size, int distance, int remainder);
  [[nodiscard]] Steps columns_of(std::int64_t unit) const;
  [[nodiscard]] Steps rows_of(std::int64_t unit) const;

  Interlace interlace_;
  PixelRectangle zone_;
  std::vector<std::int64_t> first_pixels_;  // of each unit, and behind the last one
};

}  // namespace maquette::models
