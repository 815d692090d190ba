#pragma once

#include <cstdint>

#include "firmware/ray_tree.hpp"

namespace maquette::firmware {

/// Where a component of a pixel's colour goes in the long word that a board writes: its top `bits`
/// bits, so far up.
struct ComponentPlace {
  std::uint8_t bits;
  std::uint8_t shift;
};

/// What a board is told of its work besides the scene: the units of the useful zone that it takes,
/// and how it writes their pixels.
struct BoardOrder {
  std::uint32_t first_unit;
  std::uint32_t unit_step;  ///< the number of boards
  std::uint16_t bands;      ///< units are so many bands of rows; 0: they are tiles
  /// Of a tile that the zone does not cut; of an interlace, from a board's pixel to its next one.
  std::uint16_t unit_width;
  std::uint16_t unit_height;
  std::uint16_t frame_width;   ///< pixels of a row of the frame memory
  std::uint32_t frame_memory;  ///< address of its first pixel
  std::uint32_t lock;          ///< address of the lock of the units, when they are claimed; or 0
  std::uint32_t line;          ///< of a buffer, when a line's pixels are written together; or 0
  bool has_depth;
  ComponentPlace red;
  ComponentPlace green;
  ComponentPlace blue;
};

template <class Visit>
constexpr void for_each_field(const ComponentPlace& place, Visit& visit) {
  visit(place.bits);
  visit(place.shift);
}

template <class Visit>
constexpr void for_each_field(const BoardOrder& order, Visit& visit) {
  visit(order.first_unit);
  visit(order.unit_step);
  visit(order.bands);
  visit(order.unit_width);
  visit(order.unit_height);
  visit(order.frame_width);
  visit(order.frame_memory);
  visit(order.lock);
  visit(order.line);
  visit(order.has_depth);
  visit(order.red);
  visit(order.green);
  visit(order.blue);
}

/// All that a board's program starts from.
template <class Real>
struct BoardTask {
  Frame<Real> frame;
  WorkArea<Real> area;
  BoardOrder order;
};

template <class Real, class Visit>
constexpr void for_each_field(const BoardTask<Real>& task, Visit& visit) {
  visit(task.frame);
  visit(task.area);
  visit(task.order);
}

}  // namespace maquette::firmware
