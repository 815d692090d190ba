#pragma once

#include <cstdint>

#include "firmware/primitives/generatrix.hpp"
#include "firmware/vector.hpp"

/// Faces of a solid of revolution: its sections by their numbers, and the discs at the ends of an
/// open generatrix. A face is a byte, so that of more sections those share one which are as far
/// apart as there are faces; which of them it is a point tells.
namespace maquette::firmware::revolution {

inline constexpr std::uint8_t k_first_disc = 254;
inline constexpr std::uint8_t k_last_disc = 255;
inline constexpr int k_section_faces = k_first_disc;

/// Distance from the axis.
template <class Real>
Real radius_of(const Vector<Real>& point) {
  return square_root(point.x * point.x + point.y * point.y);
}

template <int faces = k_section_faces>
constexpr std::uint8_t face_of(int section) {
  while (section >= faces) {
    section -= faces;
  }
  return static_cast<std::uint8_t>(section);
}

/// The section nearest to (r, z) of those that share one of so many faces.
template <int faces, class Real>
[[gnu::noinline]] int nearest_section(const Generatrix<Real>& curve, int face, Real r, Real z) {
  int nearest = face;
  Real least = far_away<Real>();
  for (int section = face; section < curve.sections; section += faces) {
    const Real* points = curve.section(section);
    const CurvePoint<Real> on = curve_point(points, nearest_parameter(points, r, z));
    const Real across = on.x - r;
    const Real along = on.y - z;
    const Real distance = across * across + along * along;
    if (distance < least) {
      least = distance;
      nearest = section;
    }
  }
  return nearest;
}

/// The section of a face at (r, z).
template <int faces = k_section_faces, class Real>
int section_of(const Generatrix<Real>& curve, int face, Real r, Real z) {
  return face + faces < curve.sections ? nearest_section<faces>(curve, face, r, z) : face;
}

}  // namespace maquette::firmware::revolution
