#include "sim/primitives/prism_edges.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "firmware/polynomials/spline.hpp"
#include "firmware/primitives/outline.hpp"

namespace maquette::sim {
namespace {

/// Cuts nearer to an edge's end, in its parameter, are that end.
constexpr double k_end = 1e-6;

struct Cut {
  double u;
  glm::dvec2 at;
};

void add_polygon(const std::vector<glm::dvec2>& corners, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back(straight_edge(corners[i], corners[(i + 1) % corners.size()]));
  }
}

void add_spline(const std::vector<glm::dvec2>& control, std::vector<Edge>& edges) {
  const int sections = static_cast<int>(control.size());
  std::vector<double> numbers;
  for (const glm::dvec2& point : control) {
    numbers.insert(numbers.end(), {point.x, point.y});
  }
  std::vector<double> bezier(
      static_cast<std::size_t>(sections * firmware::k_section_stride + firmware::k_point_reals));
  firmware::write_bezier_points(numbers.data(), sections, sections, bezier.data());
  for (int i = 0; i < sections; ++i) {
    const double* points = &bezier[static_cast<std::size_t>(i * firmware::k_section_stride)];
    edges.push_back({{glm::dvec2(points[0], points[1]), glm::dvec2(points[2], points[3]),
                      glm::dvec2(points[4], points[5]), glm::dvec2(points[6], points[7])},
                     false});
  }
}

bool has_length(const Edge& edge) {
  return std::any_of(edge.points.begin(), edge.points.end(),
                     [&](const glm::dvec2& point) { return point != edge.points[0]; });
}

std::vector<Edge> edges_of(const PrismShape& shape) {
  std::vector<Edge> edges;
  for (const Contour& contour : shape.contours) {
    contour.curved ? add_spline(contour.points, edges) : add_polygon(contour.points, edges);
  }
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [](const Edge& edge) { return !has_length(edge); }),
              edges.end());
  return edges;
}

/// The end at a parameter, or nothing.
const glm::dvec2* end_at(const Edge& edge, double u) {
  if (u < k_end) {
    return edge.points.data();
  }
  return u > 1 - k_end ? &edge.points[3] : nullptr;
}

/// Both edges get the same point where they meet.
void add_cuts(const Edge& a, const Edge& b, std::vector<Cut>& of_a, std::vector<Cut>& of_b) {
  for (const auto& [u, v] : crossings(a, b)) {
    const glm::dvec2* end_of_a = end_at(a, u);
    const glm::dvec2* end_of_b = end_at(b, v);
    if (end_of_a == nullptr) {
      of_a.push_back({u, end_of_b != nullptr ? *end_of_b : point_at(a, u)});
    }
    if (end_of_b == nullptr) {
      of_b.push_back({v, end_of_a != nullptr ? *end_of_a : point_at(a, u)});
    }
  }
}

/// The parts of an edge between its cuts, which are in no order.
void add_parts(Edge edge, std::vector<Cut> cuts, PrismEdges& result) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.u < b.u; });
  std::vector<Edge>& parts = edge.straight ? result.lines : result.cubics;
  double begin = 0;
  for (const Cut& cut : cuts) {
    auto [before, behind] = cut_at(edge, (cut.u - begin) / (1 - begin));
    before.points[3] = behind.points[0] = cut.at;
    parts.push_back(before);
    edge = behind;
    begin = cut.u;
  }
  parts.push_back(edge);
}

PrismEdges cut_where_crossing(const std::vector<Edge>& edges) {
  std::vector<std::vector<Cut>> cuts(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      add_cuts(edges[i], edges[k], cuts[i], cuts[k]);
    }
  }
  PrismEdges result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    add_parts(edges[i], cuts[i], result);
  }
  return result;
}

/// Writes the points of edges as the firmware takes them, from `at` on; returns the place behind.
double* write_points(const std::vector<Edge>& edges, double* at) {
  for (const Edge& edge : edges) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!edge.straight || i == 0 || i == 3) {
        *at++ = edge.points[i].x;
        *at++ = edge.points[i].y;
      }
    }
  }
  return at;
}

/// Turns the edges the way in which they stand in the firmware's parameters.
void turn_as_in(const std::vector<double>& parameters, PrismEdges& edges) {
  const auto outline = firmware::prism::outline(parameters.data());
  int number = 0;
  for (std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
    for (Edge& edge : *list) {
      const double* points = outline.edge(number++);
      const std::size_t second = edge.straight ? 3 : 1;
      const bool is_same = glm::dvec2(points[0], points[1]) == edge.points[0] &&
                           glm::dvec2(points[2], points[3]) == edge.points[second];
      if (!is_same) {
        std::reverse(edge.points.begin(), edge.points.end());
      }
    }
  }
}

}  // namespace

std::size_t crossing_count(const PrismEdges& edges) {
  return edges.lines.size() + 3 * edges.cubics.size();
}

PrismEdges prism_edges(const PrismShape& shape) {
  PrismEdges edges = cut_where_crossing(edges_of(shape));
  const std::size_t crossings = crossing_count(edges);
  if (crossings > 0 && crossings <= firmware::prism::k_crossing_limit) {
    turn_as_in(outline_parameters(edges), edges);
  }
  return edges;
}

PlaneBox box_of(const PrismEdges& edges) {
  const Edge& first = edges.lines.empty() ? edges.cubics.front() : edges.lines.front();
  PlaneBox box{first.points[0], first.points[0]};
  for (const std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
    for (const Edge& edge : *list) {
      for (const glm::dvec2& point : edge.points) {
        box.low = glm::min(box.low, point);
        box.high = glm::max(box.high, point);
      }
    }
  }
  return box;
}

double enclosed_area(const PrismEdges& edges) {
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  double area = 0;
  for (const std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
    for (const Edge& edge : *list) {
      // Green's theorem on the Bezier points.
      const auto& p = edge.points;
      area += (6 * cross(p[0], p[1]) + 3 * cross(p[0], p[2]) + cross(p[0], p[3]) +
               3 * cross(p[1], p[2]) + 3 * cross(p[1], p[3]) + 6 * cross(p[2], p[3])) /
              20;
    }
  }
  return area;
}

std::vector<double> outline_parameters(const PrismEdges& edges) {
  const int lines = static_cast<int>(edges.lines.size());
  const int cubics = static_cast<int>(edges.cubics.size());
  std::vector<double> parameters(
      static_cast<std::size_t>(firmware::prism::parameter_count(lines, cubics)));
  parameters[0] = lines;
  parameters[1] = cubics;
  const auto outline = firmware::prism::outline(parameters.data());
  double* points = parameters.data() + (outline.points - parameters.data());
  write_points(edges.cubics, write_points(edges.lines, points));
  firmware::prism::complete_parameters(parameters.data());
  return parameters;
}

}  // namespace maquette::sim
