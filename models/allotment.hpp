#pragma once

#include <cstdint>
#include <vector>

#include "models/machine_parameters.hpp"

namespace maquette::models {

/// A rectangle of pixels of the screen, the useful zone.
struct PixelRectangle {
  int column0 = 0;
  int row0 = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] std::int64_t pixels() const { return static_cast<std::int64_t>(width) * height; }
};

struct PixelPosition {
  int column;
  int row;
};

/// How `boards` boards share the pixels of a zone, and in which order each takes its own:
/// interleaved_pixels: every boards-th pixel of the row-major order;
/// interleaved_lines: every boards-th row;
/// bands: boards consecutive groups of rows, as equal as whole rows allow;
/// tiles: every boards-th tile of the row-major order of tiles (those at the right and the bottom
/// are cut by the zone), each tile row by row.
class PixelAllotment {
 public:
  /// Throws std::invalid_argument for no boards, a negative zone or empty tiles.
  PixelAllotment(Allotment kind, const PixelRectangle& zone, int boards, int tile_width,
                 int tile_height);

  /// The number of pixels of a board.
  [[nodiscard]] std::int64_t count(int board) const;

  /// The k-th pixel of a board, 0 <= k < count(board).
  [[nodiscard]] PixelPosition pixel(int board, std::int64_t k) const;

 private:
  [[nodiscard]] PixelPosition in_zone(std::int64_t column, std::int64_t row) const;
  [[nodiscard]] std::int64_t band_start(int board) const;
  [[nodiscard]] PixelRectangle tile(std::int64_t index) const;
  void place_tiles();

  Allotment kind_;
  PixelRectangle zone_;
  int boards_;
  int tile_width_;
  int tile_height_;
  std::int64_t tiles_per_row_ = 0;
  std::vector<std::vector<std::int64_t>> tile_starts_;  // by board: first k of each tile; the count
};

}  // namespace maquette::models
