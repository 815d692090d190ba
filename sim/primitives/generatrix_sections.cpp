#include "sim/primitives/generatrix_sections.hpp"

#include <cstddef>

#include "firmware/polynomials/spline.hpp"

namespace maquette::sim {

namespace {

using Points = std::vector<glm::dvec2>;

/// By the change of basis that the paper gives, as the firmware has it.
Points b_spline_sections(const Points& points, bool closed) {
  std::vector<double> control;
  for (const glm::dvec2& point : points) {
    control.insert(control.end(), {point.x, point.y});
  }
  const auto count = static_cast<int>(points.size());
  const int sections = firmware::section_count(count, !closed);
  std::vector<double> bezier(
      static_cast<std::size_t>(sections * firmware::k_section_stride + firmware::k_point_reals));
  firmware::write_bezier_points(control.data(), count, sections, bezier.data());
  Points result;
  for (std::size_t i = 0; i < bezier.size(); i += 2) {
    result.emplace_back(bezier[i], bezier[i + 1]);
  }
  return result;
}

/// Sections through points with a direction at each, per section.
Points sections_through(const Points& points, const Points& directions, bool closed) {
  const std::size_t sections = points.size() - (closed ? 0 : 1);
  Points result{points.front()};
  for (std::size_t i = 0; i < sections; ++i) {
    const std::size_t next = (i + 1) % points.size();
    result.push_back(points[i] + directions[i] / 3.0);
    result.push_back(points[next] - directions[next] / 3.0);
    result.push_back(points[next]);
  }
  return result;
}

/// Of a spline whose second derivative is continuous, and zero at open ends. Each direction weighs
/// at least twice its neighbours in its equation, so that every sweep halves what is wrong.
Points spline_directions(const Points& points, bool closed) {
  constexpr int k_sweeps = 64;
  const std::size_t count = points.size();
  Points directions(count, glm::dvec2(0, 0));
  for (int sweep = 0; sweep < k_sweeps; ++sweep) {
    for (std::size_t i = 0; i < count; ++i) {
      const bool has_last = closed || i > 0;
      const bool has_next = closed || i + 1 < count;
      const std::size_t last = has_last ? (i + count - 1) % count : i;
      const std::size_t next = has_next ? (i + 1) % count : i;
      glm::dvec2 sum = 3.0 * (points[next] - points[last]);
      sum -= has_last ? directions[last] : glm::dvec2(0, 0);
      sum -= has_next ? directions[next] : glm::dvec2(0, 0);
      directions[i] = sum / (has_last && has_next ? 4.0 : 2.0);
    }
  }
  return directions;
}

/// Straight sections from corner to corner.
Points polygon_sections(const Points& points, bool closed) {
  const std::size_t sections = points.size() - (closed ? 0 : 1);
  Points result{points.front()};
  for (std::size_t i = 0; i < sections; ++i) {
    const glm::dvec2 end = points[(i + 1) % points.size()];
    const glm::dvec2 side = end - points[i];
    result.push_back(points[i] + side / 3.0);
    result.push_back(end - side / 3.0);
    result.push_back(end);
  }
  return result;
}

}  // namespace

std::vector<glm::dvec2> sections_of(const std::vector<glm::dvec2>& points, GeneratrixKind kind,
                                    bool closed) {
  switch (kind) {
    case GeneratrixKind::b_spline:
      return b_spline_sections(points, closed);
    case GeneratrixKind::interpolating:
      return sections_through(points, spline_directions(points, closed), closed);
    case GeneratrixKind::polygon:
      return polygon_sections(points, closed);
    case GeneratrixKind::bezier:
      break;
  }
  Points sections = points;
  if (closed) {
    sections.push_back(points.front());
  }
  return sections;
}

}  // namespace maquette::sim
