#pragma once

#include "firmware/polynomials/plane_cubic.hpp"

/// From the control points of a uniform cubic B-spline in a plane to its Bezier sections (paper,
/// section IV.2.1).
namespace maquette::firmware {

/// Sections of a spline with so many control points; an open one needs four, a closed one three.
constexpr int section_count(int control_points, bool is_open) {
  return is_open ? control_points - 3 : control_points;
}

/// Change of basis: the Bezier points of all sections. `control` and `points` hold pairs; joints
/// are computed once, so that sections share them.
template <class Real>
void write_bezier_points(const Real* control, int control_points, int sections, Real* points) {
  const Real two = constant<Real>(2);
  const Real third = constant<Real>(1) / constant<Real>(3);
  const auto at = [&](int index, int coordinate) {
    charge<Real>(Operation::load);
    return control[(index < control_points ? index : index - control_points) * k_point_reals +
                   coordinate];
  };
  for (int i = 0; i <= sections; ++i) {
    for (int k = 0; k < 2; ++k) {
      const Real middle = at(i + 1, k);
      const Real after = at(i + 2, k);
      const Real twice = two * middle;
      const Real ahead = (twice + after) * third;
      Real* joint = points + i * k_section_stride + k;
      joint[0] = ((at(i, k) + twice) * third + ahead) * constant<Real>(0.5);
      if (i < sections) {
        joint[2] = ahead;
        joint[4] = (middle + two * after) * third;
      }
    }
  }
  if (section_count(control_points, false) == sections) {
    points[sections * k_section_stride] = points[0];
    points[sections * k_section_stride + 1] = points[1];
  }
}

}  // namespace maquette::firmware
