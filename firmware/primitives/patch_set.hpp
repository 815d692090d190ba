#pragma once

#include "firmware/primitives/patches.hpp"

/// From the control points of patches to the parameters of a set of patches.
namespace maquette::firmware::patches {

constexpr std::ptrdiff_t parameter_count(int patches) {
  return k_header_reals + (2 * patches - 1) * k_box_reals + patches * k_patch_stride;
}

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

/// A box around the control points of patches.
template <class Real>
Box<Real> box_of(const Real* points, int patches) {
  Vector<Real> low(points[0], points[1], points[2]);
  Vector<Real> high = low;
  for (int i = 1; i < patches * k_net_points; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Real at = points[i * k_point_reals + axis];
      low[axis] = smaller(low[axis], at);
      high[axis] = larger(high[axis], at);
    }
  }
  return {low, high};
}

/// Twice the middle of a patch's box along an axis.
template <class Real>
Real middle_of(const Real* patch, int axis) {
  const Box<Real> box = box_of(patch, 1);
  return box.low[axis] + box.high[axis];
}

/// Puts patches in the order of their middles along an axis.
template <class Real>
void order_along(Real* points, int patches, int axis) {
  for (int i = 1; i < patches; ++i) {
    for (int k = i; k > 0; --k) {
      Real* own = points + k * k_patch_stride;
      Real* before = own - k_patch_stride;
      if (!(middle_of(own, axis) < middle_of(before, axis))) {
        break;
      }
      for (int n = 0; n < k_patch_stride; ++n) {
        const Real kept = own[n];
        own[n] = before[n];
        before[n] = kept;
      }
    }
  }
}

/// Halves the patches along the longest edge of their box, again and again, and writes the boxes of
/// the tree that this makes, each node before its children.
template <class Real>
void write_tree(Real* points, int patches, Real* boxes) {
  const Box<Real> box = box_of(points, patches);
  const Vector<Real> center = (box.low + box.high) * constant<Real>(0.5);
  const Vector<Real> half = box.high - center;
  for (int axis = 0; axis < 3; ++axis) {
    boxes[axis] = center[axis];
    boxes[3 + axis] = half[axis];
  }
  if (patches == 1) {
    return;
  }
  const int longest = half.x > half.y ? (half.x > half.z ? 0 : 2) : (half.y > half.z ? 1 : 2);
  order_along(points, patches, longest);
  const int lower = patches / 2;
  write_tree(points, lower, boxes + k_box_reals);
  write_tree(points + lower * k_patch_stride, patches - lower, boxes + 2 * k_box_reals * lower);
}

/// Fills `parameters` (parameter_count) from the Bezier points of patches in the local frame.
template <class Real>
void write_parameters(const Real* bezier_points, int patches, bool is_solid,
                      SearchMethod::Value method, Real* parameters) {
  parameters[0] = from_integer<Real>(patches);
  parameters[1] = constant<Real>(is_solid ? 1 : 0);
  parameters[2] = constant<Real>(narrows(method) ? 1 : 0);
  Real* boxes = parameters + k_header_reals;
  Real* points = boxes + (2 * patches - 1) * k_box_reals;
  for (int i = 0; i < patches * k_patch_stride; ++i) {
    points[i] = bezier_points[i];
  }
  write_tree(points, patches, boxes);
}

}  // namespace maquette::firmware::patches
