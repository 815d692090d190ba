#pragma once

#include "firmware/arithmetic/work.hpp"
#include "firmware/polynomials/plane_cubic.hpp"

/// The generatrix of a solid of revolution as rays are intersected with it.
///
/// Parameters: number of sections; 1 if open, 0 if closed; tolerance of the roots that give a ray's
/// hits, in ulps; the extents of a balanced binary tree over the sections, each node before its
/// children; the control points, three for each section and the last.
namespace maquette::firmware::revolution {

inline constexpr std::ptrdiff_t k_header_reals = 3;
inline constexpr std::ptrdiff_t k_root_tolerance = 2;  ///< its place among the parameters
inline constexpr std::ptrdiff_t k_extent_reals = 4;

/// Around the control points of a node's sections.
template <class Real>
struct RingExtent {
  Real low_z;
  Real high_z;
  Real low_r;
  Real high_r;
};

template <class Real>
struct Generatrix {
  int sections;
  bool is_open;
  const Real* extents;
  const Real* points;

  [[nodiscard]] const Real* section(int number) const { return points + number * k_section_stride; }
  [[nodiscard]] RingExtent<Real> extent(int node) const {
    const Real* at = extents + node * k_extent_reals;
    charge<Real>(Operation::load, 4);
    return {at[0], at[1], at[2], at[3]};
  }
};

template <class Real>
Generatrix<Real> generatrix(const Real* parameters) {
  charge<Real>(Operation::load, 2);
  Generatrix<Real> result;
  result.sections = to_integer(parameters[0]);
  result.is_open = parameters[1] > constant<Real>(0);
  result.extents = parameters + k_header_reals;
  result.points = result.extents + (2 * result.sections - 1) * k_extent_reals;
  return result;
}

constexpr std::ptrdiff_t parameter_count(int sections) {
  return k_header_reals + (2 * sections - 1) * k_extent_reals + sections * k_section_stride +
         k_point_reals;
}

}  // namespace maquette::firmware::revolution
