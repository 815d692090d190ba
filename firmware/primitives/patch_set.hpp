#pragma once

#include "firmware/primitives/patch_net.hpp"
#include "firmware/primitives/patch_roots.hpp"

/// A set of patches as rays are intersected with it.
///
/// Parameters: number of patches; 1 for a solid, 0 for a sheet; 1 for the method `roots`, 0 for
/// `subdivision`; the boxes of a balanced binary tree over the patches, each node before its
/// children; the control points, 16 for each patch.
namespace maquette::firmware::patches {

inline constexpr int k_patch_limit = 128;
inline constexpr int k_tree_height = 7;  ///< of the binary tree over so many patches
inline constexpr std::ptrdiff_t k_header_reals = 3;
inline constexpr std::ptrdiff_t k_box_reals = 6;

template <class Real>
struct PatchSet {
  int patches;
  bool is_solid;
  SearchMethod::Value method;
  const Real* boxes;
  const Real* points;

  [[nodiscard]] const Real* patch(int number) const { return points + number * k_patch_stride; }
};

template <class Real>
PatchSet<Real> patch_set(const Real* parameters) {
  charge<Real>(Operation::load, 3);
  PatchSet<Real> set;
  set.patches = to_integer(parameters[0]);
  set.is_solid = parameters[1] > constant<Real>(0);
  set.method = parameters[2] > constant<Real>(0) ? SearchMethod::roots : SearchMethod::subdivision;
  set.boxes = parameters + k_header_reals;
  set.points = set.boxes + (2 * set.patches - 1) * k_box_reals;
  return set;
}

constexpr std::ptrdiff_t parameter_count(int patches) {
  return k_header_reals + (2 * patches - 1) * k_box_reals + patches * k_patch_stride;
}

}  // namespace maquette::firmware::patches
