#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace maquette::sim {

/// A closed line in the plane of x and y.
struct Contour {
  std::vector<glm::dvec2> points;  ///< corners, or control points of a uniform cubic B-spline
  bool curved = false;
};

/// Contours swept along z from 0 to a height, filled where a line from outside has crossed an odd
/// number of them: a contour inside another is a hole.
struct PrismShape {
  std::vector<Contour> contours;
  double height = 1;
};

}  // namespace maquette::sim
