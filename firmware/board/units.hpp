#pragma once

#include "firmware/board/short_arithmetic.hpp"
#include "firmware/board_order.hpp"

/// The units in which boards take the pixels of the useful zone.
namespace maquette::firmware::units {

inline std::uint16_t width_of(const Rectangle& zone) {
  return static_cast<std::uint16_t>(zone.end_column - zone.first_column);
}

inline std::uint16_t height_of(const Rectangle& zone) {
  return static_cast<std::uint16_t>(zone.end_row - zone.first_row);
}

/// How many parts of a size a whole is cut into, the last of which may be smaller.
inline std::uint16_t parts(std::uint16_t whole, std::uint16_t part) {
  return quotient(std::uint32_t{whole} + part - 1U, part).value;
}

inline std::uint32_t count(const BoardOrder& order, const Rectangle& zone) {
  if (order.bands != 0) {
    return order.bands;
  }
  return product(parts(width_of(zone), order.unit_width),
                 parts(height_of(zone), order.unit_height));
}

inline std::int16_t nearer_end(std::int16_t end, std::int16_t zone_end) {
  return end < zone_end ? end : zone_end;
}

inline Rectangle band(const BoardOrder& order, const Rectangle& zone, std::uint16_t unit) {
  const std::uint16_t height = height_of(zone);
  const std::uint16_t first = quotient(product(height, unit), order.bands).value;
  const std::uint16_t end =
      quotient(product(height, static_cast<std::uint16_t>(unit + 1)), order.bands).value;
  return {zone.first_column, zone.end_column, static_cast<std::int16_t>(zone.first_row + first),
          static_cast<std::int16_t>(zone.first_row + end)};
}

inline Rectangle tile(const BoardOrder& order, const Rectangle& zone, std::uint32_t unit) {
  const Quotient place = quotient(unit, parts(width_of(zone), order.unit_width));
  const auto column = static_cast<std::int16_t>(
      zone.first_column + static_cast<std::int16_t>(product(place.remainder, order.unit_width)));
  const auto row = static_cast<std::int16_t>(
      zone.first_row + static_cast<std::int16_t>(product(place.value, order.unit_height)));
  return {column, nearer_end(static_cast<std::int16_t>(column + order.unit_width), zone.end_column),
          row, nearer_end(static_cast<std::int16_t>(row + order.unit_height), zone.end_row)};
}

/// The pixels of a unit; a band may have none.
inline Rectangle pixels(const BoardOrder& order, const Rectangle& zone, std::uint32_t unit) {
  return order.bands != 0 ? band(order, zone, static_cast<std::uint16_t>(unit))
                          : tile(order, zone, unit);
}

}  // namespace maquette::firmware::units
