#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace maquette::sim {

/// Moves the control points of a generatrix: each by `amount` times its own shift (paper, section
/// IV: deformation by moving control points).
struct Displacement {
  std::string name;
  std::vector<glm::dvec2> by;  ///< (dr, dz) for every control point
  double amount = 0;
};

/// A solid of revolution about z: a uniform cubic B-spline of control points (r, z).
struct RevolutionShape {
  std::vector<glm::dvec2> points;
  bool closed = false;
  std::vector<Displacement> displacements;
};

/// The control points after all displacements.
[[nodiscard]] std::vector<glm::dvec2> displaced_points(const RevolutionShape& shape);

}  // namespace maquette::sim
