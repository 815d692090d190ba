#pragma once

#include <glm/vec2.hpp>
#include <optional>
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

/// What the points of a generatrix are.
enum class GeneratrixKind {
  b_spline,       ///< control points of a uniform cubic B-spline
  bezier,         ///< those of cubic Bezier sections, each of which begins where the last ends
  interpolating,  ///< points that a cubic spline passes, without curvature at open ends
  polygon         ///< corners
};

/// A solid of revolution about z by the points (r, z) of its generatrix.
struct RevolutionShape {
  using Kind = firmware::revolution::Kind;

  std::vector<glm::dvec2> points;
  bool closed = false;
  std::vector<Displacement> displacements;
  std::optional<GeneratrixKind> curve = std::nullopt;  ///< a B-spline where nothing is said
};

/// The control points after all displacements.
[[nodiscard]] std::vector<glm::dvec2> displaced_points(const RevolutionShape& shape);

/// A solid of revolution in the firmware's terms, as generatrix_frame says. The shape must be a
/// checked one.
[[nodiscard]] LocalFrame frame_of(const RevolutionShape& shape);

}  // namespace maquette::sim
