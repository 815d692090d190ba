#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "firmware/primitives/prism.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// A closed line in the plane of x and y.
struct Contour {
  std::vector<glm::dvec2> points;  ///< corners, or control points of a uniform cubic B-spline
  bool curved = false;
};

/// Contours swept along z from 0 to a height, filled where a line from outside has crossed an odd
/// number of them: a contour inside another is a hole.
struct PrismShape {
  using Kind = firmware::prism::Kind;

  std::vector<Contour> contours;
  double height = 1;
};

/// A prism in the firmware's terms: the rectangle around its outline reaches from -1 to 1, as do
/// its heights. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const PrismShape& shape);

}  // namespace maquette::sim
