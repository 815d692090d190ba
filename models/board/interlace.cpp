#include "models/board/interlace.hpp"

#include <algorithm>
#include <stdexcept>

namespace maquette::models {

InterlacedPixels::InterlacedPixels(const Interlace& interlace, const PixelRectangle& zone)
    : interlace_(interlace), zone_(zone), first_pixels_{0} {
  for (int unit = 0; unit < interlace.columns * interlace.lines; ++unit) {
    first_pixels_.push_back(first_pixels_.back() +
                            std::int64_t{columns_of(unit).count} * rows_of(unit).count);
  }
}

InterlacedPixels::Steps InterlacedPixels::steps(int begin, int size, int distance, int remainder) {
  const int ahead = (remainder + distance - begin % distance) % distance;
  return {begin + ahead, ahead < size ? (size - ahead - 1) / distance + 1 : 0};
}

InterlacedPixels::Steps InterlacedPixels::columns_of(std::int64_t unit) const {
  return steps(zone_.column0, zone_.width, interlace_.columns,
               static_cast<int>(unit % interlace_.columns));
}

InterlacedPixels::Steps InterlacedPixels::rows_of(std::int64_t unit) const {
  return steps(zone_.row0, zone_.height, interlace_.lines,
               static_cast<int>(unit / interlace_.columns));
}

PixelPosition InterlacedPixels::position(std::int64_t index) const {
  const auto next = std::upper_bound(first_pixels_.begin(), first_pixels_.end(), index);
  const bool is_pixel = next != first_pixels_.begin() && next != first_pixels_.end();
  const std::int64_t unit = is_pixel ? next - first_pixels_.begin() - 1 : 0;
  const Steps columns = columns_of(unit);
  if (!is_pixel || columns.count == 0) {
    throw std::out_of_range("no pixel of the zone has this index");
  }
  const std::int64_t in_unit = index - first_pixel(unit);
  return {columns.first + static_cast<int>(in_unit % columns.count) * interlace_.columns,
          rows_of(unit).first + static_cast<int>(in_unit / columns.count) * interlace_.lines};
}

std::int64_t InterlacedPixels::index(const PixelPosition& position) const {
  const std::int64_t unit = interlace_.board_of(position);
  const Steps columns = columns_of(unit);
  const std::int64_t row = (position.row - rows_of(unit).first) / interlace_.lines;
  return first_pixel(unit) + row * columns.count +
         (position.column - columns.first) / interlace_.columns;
}

}  // namespace maquette::models
