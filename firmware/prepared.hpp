#pragma once

#include <cstdint>

#include "firmware/database.hpp"

/// What preprocessing makes of the database and the synthesis of every pixel reads.
namespace maquette::firmware {

/// A rectangle of pixels; the ends are not part of it.
struct Rectangle {
  std::int16_t first_column;
  std::int16_t end_column;
  std::int16_t first_row;
  std::int16_t end_row;

  [[nodiscard]] constexpr bool is_empty() const {
    return first_column >= end_column || first_row >= end_row;
  }
  [[nodiscard]] constexpr bool contains(std::int32_t column, std::int32_t row) const {
    return column >= first_column && column < end_column && row >= first_row && row < end_row;
  }
};

/// Axis-aligned in the screen frame.
template <class Real>
struct Box {
  Vector<Real> low;
  Vector<Real> high;
};

template <class Real>
struct Sphere {
  Vector<Real> center;
  Real radius;
  Real radius_squared;
};

/// Volumes around a node: the box gives the rectangle for primary rays, the sphere serves secondary
/// rays (paper, section V.2.3.1.2).
template <class Real>
struct Extent {
  Box<Real> box;
  Sphere<Real> sphere;
  Rectangle rectangle;
  bool bounded;      ///< false: box and sphere hold nothing, the rectangle is the screen
  bool transparent;  ///< a leaf below is of a transparent surface
};

template <class Real>
struct PreparedLeaf {
  Affine<Real> to_screen;  ///< local frame to screen frame
  Affine<Real> from_screen;
  Real scale;  ///< largest coordinate that enters its computations: size plus distance from the eye
};

template <class Real>
struct PreparedSurface {
  Color<Real> diffuse;  ///< bidirectional reflectance d * Rd
  Color<Real> ambient;  ///< luminance under the ambient light
};

/// How depths become the codes of a depth memory.
template <class Real>
struct DepthRange {
  Real low;  ///< code 0
  Real codes_per_unit;
};

template <class Real>
struct Prepared {
  PreparedLeaf<Real>* leaves;       ///< leaf_count
  Extent<Real>* extents;            ///< node_count
  PreparedSurface<Real>* surfaces;  ///< surface_count
  Vector<Real>* light_positions;    ///< light_count, screen frame
  Vector<Real>* light_axes;         ///< of shaped lights: light_count, screen frame
  Rectangle useful_zone;
  Real coarse_tolerance;    ///< no two distances of a ray are taken as equal beyond it
  DepthRange<Real> depths;  ///< where the scene needs them
};

/// Everything that a frame's pixels read.
template <class Real>
struct Frame {
  Database<Real> database;
  Prepared<Real> prepared;
};

}  // namespace maquette::firmware
