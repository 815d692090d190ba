#pragma once

#include "sim/primitives/edge_crossings.hpp"
#include "sim/primitives/prism.hpp"

namespace maquette::sim {

/// The outline of a prism.
struct PrismEdges {
  std::vector<Edge> lines;
  std::vector<Edge> cubics;
};

struct PlaneBox {
  glm::dvec2 low;
  glm::dvec2 high;
};

/// The most crossings of a line with an outline: one for a straight edge, three for a cubic one.
[[nodiscard]] std::size_t crossing_count(const PrismEdges& edges);

/// The contours' edges, cut where they cross one another. Edges without length are left out. If the
/// firmware takes so many, each has the solid on its left.
[[nodiscard]] PrismEdges prism_edges(const PrismShape& shape);

/// Around the Bezier points.
[[nodiscard]] PlaneBox box_of(const PrismEdges& edges);

[[nodiscard]] double enclosed_area(const PrismEdges& edges);

/// The firmware's parameters of an outline, which are turned and given extents there.
[[nodiscard]] std::vector<double> outline_parameters(const PrismEdges& edges);

}  // namespace maquette::sim
