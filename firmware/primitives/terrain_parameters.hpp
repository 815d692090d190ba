#pragma once

#include "firmware/primitives/terrain_triangle.hpp"

/// From the description of a terrain to the parameters of its primitive: the levels and what they
/// may add. Boards do it before all other preprocessing.
///
/// Given: the members of a shape, in their order.
namespace maquette::firmware::terrain {

template <class Real>
struct Shape {
  std::int32_t levels;  ///< 0 .. k_level_limit
  std::int32_t seed;    ///< 0 .. k_seed_end - 1
  Real floor;
  Real corners[4];    ///< heights at (0, 0), (1, 0), (0, 1), (1, 1)
  Real displacement;  ///< the greatest one of the first level's midpoints
  Real roughness;     ///< ratio of each level's greatest displacement to that of the one before
};

/// By which sums grow, so that they remain bounds when they are rounded to single precision, and
/// heights that are.
inline constexpr double k_margin = 2e-6;

inline constexpr std::ptrdiff_t k_given_reals = 9;

constexpr std::ptrdiff_t parameter_count(std::int32_t levels) {
  return k_header_reals + levels * k_level_reals;
}

/// The sum of the greatest displacements of all levels.
template <class Real>
Real thickness_of(const Shape<Real>& shape) {
  Real sum = constant<Real>(0);
  Real displacement = shape.displacement;
  for (std::int32_t level = 0; level < shape.levels; ++level) {
    sum += displacement;
    displacement *= shape.roughness;
  }
  return sum;
}

/// A bound of the surface's heights above 0.
template <class Real>
Real top_of(const Shape<Real>& shape) {
  const Real* c = shape.corners;
  const Real highest = larger(larger(c[0], c[1]), larger(c[2], c[3]));
  const Real thickness = thickness_of(shape);
  return highest + thickness + (absolute(highest) + thickness) * constant<Real>(k_margin);
}

/// Fills `parameters` (parameter_count).
template <class Real>
void write_parameters(const Shape<Real>& shape, Real* parameters) {
  parameters[0] = from_integer<Real>(shape.levels);
  parameters[1] = from_integer<Real>(shape.seed);
  parameters[2] = shape.floor;
  parameters[3] = top_of(shape);
  for (int i = 0; i < 4; ++i) {
    parameters[4 + i] = shape.corners[i];
  }
  Shape<Real> rest = shape;
  for (Real* level = parameters + k_header_reals; rest.levels > 0; level += k_level_reals) {
    level[0] = rest.displacement;
    level[1] = thickness_of(rest) * constant<Real>(1 + k_margin);
    rest.displacement *= rest.roughness;
    --rest.levels;
  }
}

/// Fills the parameters of what is given; returns the end of it.
template <class Real>
const Real* convert(const Real* given, Real* parameters) {
  charge<Real>(Operation::load, k_given_reals);
  write_parameters<Real>({to_integer(given[0]),
                          to_integer(given[1]),
                          given[2],
                          {given[3], given[4], given[5], given[6]},
                          given[7],
                          given[8]},
                         parameters);
  return given + k_given_reals;
}

}  // namespace maquette::firmware::terrain
