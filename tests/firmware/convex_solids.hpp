#pragma once

#include <cmath>
#include <iterator>

#include "firmware/primitives/primitive_table.hpp"

/// The convex primitives as sets of points, for tests that hold them against their definitions.
/// Laws of every primitive of the table are in tests/sim/primitives/test_primitive_table.cpp.
namespace maquette::firmware::trial {

struct ConvexSolid {
  PrimitiveKind kind;
  /// Below 0 inside, above 0 outside, about the distance to the surface nearby. The first number is
  /// the only parameter, of those that take one.
  double (*outside_by)(double parameter, const Vector<double>& p);
  Vector<double> inner_point;
};

inline double outside_cylinder_by(double /*parameter*/, const Vector<double>& p) {
  return larger(std::hypot(p.x, p.y), absolute(p.z)) - 1;
}

inline double outside_cone_by(double top, const Vector<double>& p) {
  return larger(std::hypot(p.x, p.y) - p.z, larger(p.z - 1, top - p.z));
}

inline const ConvexSolid k_convex_solids[] = {
    {kind_of<half_space::Kind>, [](double, const Vector<double>& p) { return p.z; }, {0, 0, -0.5}},
    {kind_of<box::Kind>,
     [](double, const Vector<double>& p) { return magnitude(p) - 1; },
     {0, 0, 0}},
    {kind_of<sphere::Kind>,
     [](double, const Vector<double>& p) { return glm::length(p) - 1; },
     {0, 0, 0}},
    {kind_of<cylinder::Kind>, outside_cylinder_by, {0, 0, 0}},
    {kind_of<cone::Kind>, outside_cone_by, {0, 0, 0.95}}};

inline constexpr int k_convex_solid_count = std::size(k_convex_solids);

}  // namespace maquette::firmware::trial
