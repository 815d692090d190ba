#pragma once

#include "firmware/polynomials/spline.hpp"
#include "firmware/primitives/revolution.hpp"

/// From the control points of a uniform cubic B-spline, or from sections, to the parameters of a
/// solid of revolution (paper, sections IV.2.1 and IV.2.2).
namespace maquette::firmware::revolution {

constexpr std::ptrdiff_t parameter_count(int sections) {
  return k_header_reals + (2 * sections - 1) * k_extent_reals + sections * k_section_stride +
         k_point_reals;
}

/// Extents of the tree's nodes from the control points, each node before its children.
template <class Real>
void write_extents(const Real* points, int sections, Real* extents) {
  Real* own = extents;
  own[0] = own[1] = points[1];
  own[2] = own[3] = points[0];
  for (int i = 1; i <= 3 * sections; ++i) {
    charge<Real>(Operation::load, 2);
    const Real* point = points + i * k_point_reals;
    own[0] = smaller(own[0], point[1]);
    own[1] = larger(own[1], point[1]);
    own[2] = smaller(own[2], point[0]);
    own[3] = larger(own[3], point[0]);
  }
  if (sections > 1) {
    const int half = sections / 2;
    write_extents(points, half, extents + k_extent_reals);
    write_extents(points + half * k_section_stride, sections - half,
                  extents + half * (2 * k_extent_reals));
  }
}

/// Fills what precedes the extents. Returns where the Bezier points lie.
template <class Real>
Real* write_header(int sections, bool is_open, Real* parameters) {
  parameters[0] = from_integer<Real>(sections);
  parameters[1] = constant<Real>(is_open ? 1 : 0);
  parameters[k_root_tolerance] = constant<Real>(1);
  return parameters + k_header_reals + (2 * sections - 1) * k_extent_reals;
}

/// Fills `parameters` (parameter_count) from pairs (r, z) of control points.
template <class Real>
void write_parameters(const Real* control, int control_points, bool is_open, Real* parameters) {
  const int sections = section_count(control_points, is_open);
  Real* points = write_header(sections, is_open, parameters);
  write_bezier_points(control, control_points, sections, points);
  write_extents(points, sections, parameters + k_header_reals);
}

/// Fills `parameters` from pairs (r, z) of Bezier points, three for each section and the last.
template <class Real>
void write_section_parameters(const Real* bezier, int sections, bool is_open, Real* parameters) {
  Real* points = write_header(sections, is_open, parameters);
  for (int i = 0; i < sections * k_section_stride + k_point_reals; ++i) {
    points[i] = bezier[i];
  }
  write_extents(points, sections, parameters + k_header_reals);
}

}  // namespace maquette::firmware::revolution
