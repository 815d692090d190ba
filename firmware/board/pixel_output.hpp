#pragma once

#include "firmware/board/short_arithmetic.hpp"
#include "firmware/board_order.hpp"
#include "firmware/synthesize.hpp"

/// How a board writes its pixels into the frame memory: each at once, or a line of them together.
namespace maquette::firmware {

/// A pixel as the frame memory takes it.
inline std::uint32_t written(const BoardOrder& order, const PixelOf<BoardNumber>& pixel) {
  if (!order.has_depth) {
    return pixel.rgb << 8U;
  }
  const auto placed = [](std::uint32_t component, const ComponentPlace& place) {
    return (component & 0xFFU) >> (8U - place.bits) << place.shift;
  };
  return placed(pixel.rgb >> 16U, order.red) | placed(pixel.rgb >> 8U, order.green) |
         placed(pixel.rgb, order.blue) | pixel.depth;
}

/// The bus is a word wide: two writes a pixel.
inline void write_pixel(const BoardOrder& order, std::int16_t column, std::int16_t row,
                        std::uint32_t bytes) {
  const std::uint32_t index = product(static_cast<std::uint16_t>(row), order.frame_width) +
                              static_cast<std::uint16_t>(column);
  auto* const place = reinterpret_cast<volatile std::uint16_t*>(order.frame_memory + 4 * index);
  place[0] = static_cast<std::uint16_t>(bytes >> 16U);
  place[1] = static_cast<std::uint16_t>(bytes);
}

/// Pixels of one row that wait to be written, at equal distances.
struct Line {
  std::int16_t first_column;
  std::int16_t row;
  std::int16_t count;
  std::int16_t distance;
};

inline void flush(const BoardOrder& order, Line& line) {
  const auto* const pixels = reinterpret_cast<const std::uint32_t*>(order.line);
  std::int16_t column = line.first_column;
  for (std::int16_t i = 0; i < line.count; ++i) {
    write_pixel(order, column, line.row, pixels[i]);
    column = static_cast<std::int16_t>(column + line.distance);
  }
  line.count = 0;
}

inline void put(const BoardOrder& order, Line& line, std::int16_t column, std::int16_t row,
                const PixelOf<BoardNumber>& pixel) {
  if (order.line == 0) {
    write_pixel(order, column, row, written(order, pixel));
    return;
  }
  if (line.count == 0) {
    line.first_column = column;
    line.row = row;
  }
  reinterpret_cast<std::uint32_t*>(order.line)[line.count++] = written(order, pixel);
}

}  // namespace maquette::firmware
