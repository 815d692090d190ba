#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace maquette::sim {

/// A part of a contour by its Bezier points; those of a straight one lie at thirds of it.
struct Edge {
  std::array<glm::dvec2, 4> points{};
  bool straight = true;
};

[[nodiscard]] Edge straight_edge(const glm::dvec2& first, const glm::dvec2& last);

[[nodiscard]] glm::dvec2 point_at(const Edge& edge, double u);

/// The part before u and the part behind it.
[[nodiscard]] std::pair<Edge, Edge> cut_at(const Edge& edge, double u);

/// Where an edge crosses or touches another, as a pair of parameters, in order of the first; to
/// about 1e-10 of the edges. None where they lie on one another.
[[nodiscard]] std::vector<std::pair<double, double>> crossings(const Edge& a, const Edge& b);

}  // namespace maquette::sim
