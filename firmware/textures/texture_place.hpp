#pragma once

#include "firmware/database.hpp"

namespace maquette::firmware {

/// Where a texture is looked up.
template <class Real>
struct TexturePlace {
  const Database<Real>& database;
  const Texture<Real>& texture;
  Vector<Real> local;  ///< in the frame of the leaf
  NodeIndex leaf;
  std::uint8_t face;
};

/// Cells lie so far off the planes of whole numbers, in cells, that a face laid on such a plane
/// lies within one.
inline constexpr double k_cell_offset = 1.0 / 1024;

/// Beyond so many cells from the origin of its frame a pattern has no more of them.
inline constexpr double k_farthest_cell = 1e6;

/// Number of the cell in which a coordinate lies: the whole number below it.
template <class Real>
std::int32_t cell_of(Real coordinate) {
  const Real farthest = constant<Real>(k_farthest_cell);
  const Real inside =
      larger(-farthest, smaller(coordinate, farthest)) + constant<Real>(k_cell_offset);
  const std::int32_t cell = to_integer(inside);
  return inside < constant<Real>(0) ? cell - 1 : cell;
}

/// The colour of a cell: those of odd numbers have the second.
template <class Real>
Color<Real> cell_color(const Texture<Real>& texture, std::int32_t cell) {
  charge<Real>(Operation::load, 3);
  return texture.colors[cell & 1];
}

/// The place in the frame of the pattern.
template <class Real>
Vector<Real> pattern_point(const TexturePlace<Real>& place) {
  return transform_point(place.texture.from_leaf, place.local);
}

}  // namespace maquette::firmware
