#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "firmware/primitives/revolution.hpp"
#include "sim/primitives/local_frame.hpp"

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
  using Kind = firmware::revolution::Kind;

  std::vector<glm::dvec2> points;
  bool closed = false;
  std::vector<Displacement> displacements;
};

/// The control points after all displacements.
[[nodiscard]] std::vector<glm::dvec2> displaced_points(const RevolutionShape& shape);

/// A solid of revolution in the firmware's terms: the axis is z, the largest radius of a Bezier
/// point is 1, heights reach from -1 to 1; the generatrix has the solid on its left (paper, section
/// IV.2). The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const RevolutionShape& shape);

}  // namespace maquette::sim
