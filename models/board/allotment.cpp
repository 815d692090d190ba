#include "models/board/allotment.hpp"

#include <algorithm>
#include <stdexcept>

namespace maquette::models {

namespace {

std::int64_t parts(int whole, int part) {
  return (static_cast<std::int64_t>(whole) + part - 1) / part;
}

void check(const PixelRectangle& zone, int boards) {
  if (boards < 1) {
    throw std::invalid_argument("pixels are allotted to at least one board");
  }
  if (zone.width < 0 || zone.height < 0) {
    throw std::invalid_argument("the useful zone must not have a negative size");
  }
}

void check_tile(const AllotmentParameters& parameters) {
  if (parameters.tile_width < 1 || parameters.tile_height < 1) {
    throw std::invalid_argument("tiles must have pixels");
  }
}

}  // namespace

PixelAllotment::PixelAllotment(const AllotmentParameters& parameters, const PixelRectangle& zone,
                               int boards)
    : zone_(zone), unit_width_(std::max(zone.width, 1)) {
  check(zone, boards);
  switch (parameters.order) {
    case Allotment::interleaved_pixels:
      unit_width_ = 1;
      break;
    case Allotment::interleaved_lines:
      break;
    case Allotment::bands:
      cut_in_bands_ = true;
      break;
    case Allotment::tiles:
      check_tile(parameters);
      unit_width_ = parameters.tile_width;
      unit_height_ = parameters.tile_height;
      break;
    case Allotment::interlaced:
      interlaced_.emplace(interlace_of(parameters, boards), zone);
      break;
  }
  units_are_equal_ = !cut_in_bands_ && unit_height_ == 1 && zone.width % unit_width_ == 0;
  units_per_row_ = parts(zone.width, unit_width_);
  units_ =
      cut_in_bands_ || interlaced_ ? boards : units_per_row_ * parts(zone.height, unit_height_);
}

std::int64_t PixelAllotment::first_pixel(std::int64_t unit) const {
  if (interlaced_) {
    return interlaced_->first_pixel(unit);
  }
  if (cut_in_bands_) {
    return zone_.height * unit / units_ * zone_.width;
  }
  if (units_are_equal_) {
    return unit * unit_width_;
  }
  if (unit == units_) {
    return pixels();
  }
  const std::int64_t row = unit / units_per_row_ * unit_height_;
  const std::int64_t column = unit % units_per_row_ * unit_width_;
  const std::int64_t height = std::min<std::int64_t>(unit_height_, zone_.height - row);
  return row * zone_.width + column * height;
}

PixelPosition PixelAllotment::in_zone(std::int64_t column, std::int64_t row) const {
  return {zone_.column0 + static_cast<int>(column), zone_.row0 + static_cast<int>(row)};
}

PixelPosition PixelAllotment::position(std::int64_t index) const {
  if (interlaced_) {
    return interlaced_->position(index);
  }
  if (unit_height_ == 1) {
    return in_zone(index % zone_.width, index / zone_.width);
  }
  // A row of units holds whole rows of the zone.
  const std::int64_t row = index / zone_.width / unit_height_ * unit_height_;
  const std::int64_t height = std::min<std::int64_t>(unit_height_, zone_.height - row);
  const std::int64_t in_units_row = index - row * zone_.width;
  const std::int64_t column = in_units_row / height / unit_width_ * unit_width_;
  const std::int64_t width = std::min<std::int64_t>(unit_width_, zone_.width - column);
  const std::int64_t in_unit = in_units_row - column * height;
  return in_zone(column + in_unit % width, row + in_unit / width);
}

std::int64_t PixelAllotment::index(const PixelPosition& position) const {
  if (interlaced_) {
    return interlaced_->index(position);
  }
  const std::int64_t column = position.column - zone_.column0;
  const std::int64_t row = position.row - zone_.row0;
  if (unit_height_ == 1) {
    return row * zone_.width + column;
  }
  const std::int64_t first_row = row / unit_height_ * unit_height_;
  const std::int64_t height = std::min<std::int64_t>(unit_height_, zone_.height - first_row);
  const std::int64_t first_column = column / unit_width_ * unit_width_;
  const std::int64_t width = std::min<std::int64_t>(unit_width_, zone_.width - first_column);
  return first_row * zone_.width + first_column * height + (row - first_row) * width +
         (column - first_column);
}

}  // namespace maquette::models
