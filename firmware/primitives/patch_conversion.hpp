#pragma once

#include "firmware/extent.hpp"
#include "firmware/primitives/patch_set.hpp"

/// From a net of control points, of B-splines or Bezier patches, to the parameters of a set of
/// patches: change of basis and extents. Boards do it before all other preprocessing.
///
/// Given: the first three parameters; 1 if B-spline, 0 if Bezier; the number of control points; the
/// points; of each patch the numbers of its 16 points. Which way its normals point, and which
/// patches lie together in the tree, follows from the order of numbers and patches.
namespace maquette::firmware::patches {

inline constexpr std::ptrdiff_t k_given_basis = 3;
inline constexpr std::ptrdiff_t k_given_points = 4;
inline constexpr std::ptrdiff_t k_given_header_reals = 5;

/// Change of basis of one curve of a uniform cubic B-spline, four ordinates `step` apart, in place.
/// A curve read backwards gives the same numbers.
template <class Real>
void spline_to_bezier(Real* at, std::ptrdiff_t step) {
  const Real two = constant<Real>(2);
  const Real third = constant<Real>(1) / constant<Real>(3);
  const Real sixth = third * constant<Real>(0.5);
  const Real a = at[0];
  const Real b = at[step];
  const Real c = at[2 * step];
  const Real d = at[3 * step];
  at[0] = (a + c + two * (b + b)) * sixth;
  at[step] = (two * b + c) * third;
  at[2 * step] = (b + two * c) * third;
  at[3 * step] = (b + d + two * (c + c)) * sixth;
}

/// Change of basis of a B-spline patch (16 points) in place.
template <class Real>
void spline_to_bezier(Real* points) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      spline_to_bezier(points + axis + 4 * k_point_reals * i, k_point_reals);
    }
    for (int i = 0; i < 4; ++i) {
      spline_to_bezier(points + axis + i * k_point_reals, 4 * k_point_reals);
    }
  }
}

/// Copies the 16 control points of a patch.
template <class Real>
void gather(const Real* net, const Real* numbers, Real* points) {
  for (int i = 0; i < k_net_points; ++i) {
    charge<Real>(Operation::load, 1 + k_point_reals);
    const Real* from = net + to_integer(numbers[i]) * k_point_reals;
    for (int axis = 0; axis < k_point_reals; ++axis) {
      points[i * k_point_reals + axis] = from[axis];
    }
  }
}

/// Around the control points of one patch.
template <class Real>
Box<Real> box_of(const Real* points) {
  charge<Real>(Operation::load, k_patch_stride);
  Box<Real> box{{points[0], points[1], points[2]}, {points[0], points[1], points[2]}};
  for (int i = 1; i < k_net_points; ++i) {
    const Real* at = points + i * k_point_reals;
    const Vector<Real> point(at[0], at[1], at[2]);
    box = {lower(box.low, point), higher(box.high, point)};
  }
  return box;
}

/// Writes the boxes of a node of the tree and of those below it, each before its children; returns
/// the node's.
template <class Real>
Box<Real> write_boxes(const Real* points, int patches, Real* boxes) {
  charge<Real>(Operation::part);
  Box<Real> box;
  if (patches == 1) {
    box = box_of(points);
  } else {
    const int half = patches / 2;
    const Box<Real> a = write_boxes(points, half, boxes + k_box_reals);
    const Box<Real> b = write_boxes(points + half * k_patch_stride, patches - half,
                                    boxes + half * (2 * k_box_reals));
    box = {lower(a.low, b.low), higher(a.high, b.high)};
  }
  const Vector<Real> center = (box.low + box.high) * constant<Real>(0.5);
  const Vector<Real> half = box.high - center;
  for (int axis = 0; axis < 3; ++axis) {
    boxes[axis] = center[axis];
    boxes[3 + axis] = half[axis];
  }
  return box;
}

/// Fills the parameters (parameter_count) of what is given; returns the end of it.
template <class Real>
const Real* convert(const Real* given, Real* parameters) {
  charge<Real>(Operation::load, k_given_header_reals);
  const int patches = to_integer(given[0]);
  const bool is_spline = given[k_given_basis] > constant<Real>(0);
  const Real* net = given + k_given_header_reals;
  const Real* numbers = net + to_integer(given[k_given_points]) * k_point_reals;
  for (int i = 0; i < k_header_reals; ++i) {
    parameters[i] = given[i];
  }
  Real* boxes = parameters + k_header_reals;
  Real* points = boxes + (2 * patches - 1) * k_box_reals;
  for (int patch = 0; patch < patches; ++patch) {
    Real* own = points + patch * k_patch_stride;
    gather(net, numbers + patch * k_net_points, own);
    if (is_spline) {
      spline_to_bezier(own);
    }
  }
  write_boxes(points, patches, boxes);
  return numbers + patches * k_net_points;
}

}  // namespace maquette::firmware::patches
