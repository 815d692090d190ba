#include "models/allotment.hpp"

#include <algorithm>
#include <stdexcept>

namespace maquette::models {

namespace {

std::int64_t every_nth(std::int64_t total, int first, int n) {
  return total <= first ? 0 : (total - first - 1) / n + 1;
}

std::int64_t parts(int whole, int part) {
  return (static_cast<std::int64_t>(whole) + part - 1) / part;
}

}  // namespace

PixelAllotment::PixelAllotment(Allotment kind, const PixelRectangle& zone, int boards,
                               int tile_width, int tile_height)
    : kind_(kind),
      zone_(zone),
      boards_(boards),
      tile_width_(tile_width),
      tile_height_(tile_height) {
  if (boards < 1) {
    throw std::invalid_argument("pixels are allotted to at least one board");
  }
  if (zone.width < 0 || zone.height < 0) {
    throw std::invalid_argument("the useful zone must not have a negative size");
  }
  if (kind == Allotment::tiles) {
    place_tiles();
  }
}

void PixelAllotment::place_tiles() {
  if (tile_width_ < 1 || tile_height_ < 1) {
    throw std::invalid_argument("tiles must have pixels");
  }
  tiles_per_row_ = parts(zone_.width, tile_width_);
  const std::int64_t tiles = tiles_per_row_ * parts(zone_.height, tile_height_);
  tile_starts_.assign(static_cast<std::size_t>(boards_), {0});
  for (std::int64_t index = 0; index < tiles; ++index) {
    auto& starts = tile_starts_[static_cast<std::size_t>(index % boards_)];
    starts.push_back(starts.back() + tile(index).pixels());
  }
}

PixelRectangle PixelAllotment::tile(std::int64_t index) const {
  const auto column = static_cast<int>(index % tiles_per_row_) * tile_width_;
  const auto row = static_cast<int>(index / tiles_per_row_) * tile_height_;
  return {column, row, std::min(tile_width_, zone_.width - column),
          std::min(tile_height_, zone_.height - row)};
}

std::int64_t PixelAllotment::band_start(int board) const {
  return static_cast<std::int64_t>(zone_.height) * board / boards_;
}

std::int64_t PixelAllotment::count(int board) const {
  switch (kind_) {
    case Allotment::interleaved_pixels:
      return every_nth(zone_.pixels(), board, boards_);
    case Allotment::interleaved_lines:
      return every_nth(zone_.height, board, boards_) * zone_.width;
    case Allotment::bands:
      return (band_start(board + 1) - band_start(board)) * zone_.width;
    case Allotment::tiles:
      return tile_starts_[static_cast<std::size_t>(board)].back();
  }
  return 0;
}

PixelPosition PixelAllotment::in_zone(std::int64_t column, std::int64_t row) const {
  return {zone_.column0 + static_cast<int>(column), zone_.row0 + static_cast<int>(row)};
}

PixelPosition PixelAllotment::pixel(int board, std::int64_t k) const {
  switch (kind_) {
    case Allotment::interleaved_pixels: {
      const std::int64_t index = board + k * boards_;
      return in_zone(index % zone_.width, index / zone_.width);
    }
    case Allotment::interleaved_lines:
      return in_zone(k % zone_.width, board + k / zone_.width * boards_);
    case Allotment::bands:
      return in_zone(k % zone_.width, band_start(board) + k / zone_.width);
    case Allotment::tiles:
      break;
  }
  const auto& starts = tile_starts_[static_cast<std::size_t>(board)];
  const auto after = std::upper_bound(starts.begin(), starts.end(), k);
  const std::int64_t turn = after - starts.begin() - 1;
  const PixelRectangle place = tile(board + turn * boards_);
  const std::int64_t within = k - starts[static_cast<std::size_t>(turn)];
  return in_zone(place.column0 + within % place.width, place.row0 + within / place.width);
}

}  // namespace maquette::models
