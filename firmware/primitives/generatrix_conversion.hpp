#pragma once

#include "firmware/arithmetic/function.hpp"
#include "firmware/polynomials/spline.hpp"
#include "firmware/primitives/generatrix.hpp"

/// From the control points of a uniform cubic B-spline, or of Bezier sections, to the parameters of
/// a generatrix: change of basis, orientation, extents (paper, sections IV.2.1 and IV.2.2). Boards
/// do it before all other preprocessing.
///
/// Given: number of sections; 1 if open, 0 if closed; tolerance of the roots; 1 if B-spline, 0 if
/// Bezier; pairs (r, z) of control points, of Bezier ones three for each section and the last.
namespace maquette::firmware::revolution {

inline constexpr std::ptrdiff_t k_given_basis = 3;
inline constexpr std::ptrdiff_t k_given_header_reals = 4;

/// Twenty times the integral of r dz along a section.
template <class Real>
Real swept(const Real* points) {
  charge<Real>(Operation::load, 8);
  const Real three = constant<Real>(3);
  const Real four = constant<Real>(4);
  const Real six = constant<Real>(6);
  const Real ten = constant<Real>(10);
  const Real first = points[0];
  const Real second = points[2];
  const Real third = points[4];
  const Real last = points[6];
  return (points[3] - points[1]) * (ten * first + six * second + (three * third + last)) +
         (points[5] - points[3]) * (four * (first + last) + six * (second + third)) +
         (points[7] - points[5]) * (first + three * second + (six * third + ten * last));
}

/// Whether the chain, closed along the axis where it is open, has what it encloses on its left.
template <class Real>
bool is_left_of_solid(const Real* points, int sections) {
  Real area = constant<Real>(0);
  for (int i = 0; i < sections; ++i) {
    area += swept(points + i * k_section_stride);
  }
  return !(area < constant<Real>(0));
}

/// The chain the other way round.
template <class Real>
void reverse(Real* points, int sections) {
  Real* other = points + sections * k_section_stride;
  for (; points < other; points += k_point_reals, other -= k_point_reals) {
    charge<Real>(Operation::load, 4);
    for (int k = 0; k < k_point_reals; ++k) {
      const Real kept = points[k];
      points[k] = other[k];
      other[k] = kept;
    }
  }
}

/// Around the control points of one section.
template <class Real>
RingExtent<Real> extent_of(const Real* points) {
  charge<Real>(Operation::load, 8);
  RingExtent<Real> extent{points[1], points[1], points[0], points[0]};
  for (int i = 1; i < 4; ++i) {
    const Real* point = points + i * k_point_reals;
    extent = {smaller(extent.low_z, point[1]), larger(extent.high_z, point[1]),
              smaller(extent.low_r, point[0]), larger(extent.high_r, point[0])};
  }
  return extent;
}

/// Extents of a node of the tree and of those below it, each behind that of its parent; returns the
/// node's.
template <class Real>
RingExtent<Real> write_extents(const Real* points, int sections, Real* extents) {
  charge<Real>(Operation::part);
  RingExtent<Real> extent;
  if (sections == 1) {
    extent = extent_of(points);
  } else {
    const int half = sections / 2;
    const RingExtent<Real> a = write_extents(points, half, extents + k_extent_reals);
    const RingExtent<Real> b = write_extents(points + half * k_section_stride, sections - half,
                                             extents + half * (2 * k_extent_reals));
    extent = {smaller(a.low_z, b.low_z), larger(a.high_z, b.high_z), smaller(a.low_r, b.low_r),
              larger(a.high_r, b.high_r)};
  }
  extents[0] = extent.low_z;
  extents[1] = extent.high_z;
  extents[2] = extent.low_r;
  extents[3] = extent.high_r;
  return extent;
}

/// Copies control points of Bezier sections; returns the end of those given.
template <class Real>
const Real* copy_points(const Real* control, int sections, Real* points) {
  for (int i = 0; i < sections * k_section_stride + k_point_reals; ++i) {
    charge<Real>(Operation::load);
    points[i] = control[i];
  }
  return control + (sections * k_section_stride + k_point_reals);
}

/// Fills the parameters (parameter_count) of what is given; returns the end of it.
template <class Real>
const Real* convert(const Real* given, Real* parameters) {
  charge<Real>(Operation::load, k_given_header_reals);
  const Real zero = constant<Real>(0);
  const int sections = to_integer(given[0]);
  const bool is_open = given[1] > zero;
  for (int i = 0; i < k_header_reals; ++i) {
    parameters[i] = given[i];
  }
  Real* extents = parameters + k_header_reals;
  Real* points = extents + (2 * sections - 1) * k_extent_reals;
  const Real* control = given + k_given_header_reals;
  const Real* end = nullptr;
  if (given[k_given_basis] > zero) {
    const int control_points = sections + (is_open ? 3 : 0);
    write_bezier_points(control, control_points, sections, points);
    end = control + control_points * k_point_reals;
  } else {
    end = copy_points(control, sections, points);
  }
  if (!is_left_of_solid(points, sections)) {
    reverse(points, sections);
  }
  write_extents(points, sections, extents);
  return end;
}

}  // namespace maquette::firmware::revolution
