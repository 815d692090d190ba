#include "sim/primitives/generatrix_curve.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "sim/primitives/generatrix_sections.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_chords = 16;

glm::dvec2 point_at(const GeneratrixCurve& curve, std::size_t section, double u) {
  const glm::dvec2* p = &curve.points[3 * section];
  const double v = 1 - u;
  return v * v * v * p[0] + 3 * u * v * (v * p[1] + u * p[2]) + u * u * u * p[3];
}

glm::dvec2 change_at(const GeneratrixCurve& curve, std::size_t section, double u) {
  const glm::dvec2* p = &curve.points[3 * section];
  const double v = 1 - u;
  return 3.0 * (v * v * (p[1] - p[0]) + 2 * u * v * (p[2] - p[1]) + u * u * (p[3] - p[2]));
}

/// Twice the area of a triangle, positive when it turns left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool properly_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                    const glm::dvec2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

Extent2 extent_around(const glm::dvec2* first, const glm::dvec2* end) {
  Extent2 extent{*first, *first};
  for (const glm::dvec2* point = first; point != end; ++point) {
    extent.low = glm::min(extent.low, *point);
    extent.high = glm::max(extent.high, *point);
  }
  return extent;
}

std::vector<Extent2> section_extents(const GeneratrixCurve& curve) {
  std::vector<Extent2> extents;
  for (std::size_t section = 0; section < curve.sections(); ++section) {
    const glm::dvec2* first = &curve.points[3 * section];
    extents.push_back(extent_around(first, first + 4));
  }
  return extents;
}

bool overlap(const Extent2& a, const Extent2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// A section and those after it that it may meet.
std::vector<std::size_t> sections_near(const std::vector<Extent2>& extents, std::size_t section) {
  std::vector<std::size_t> near;
  for (std::size_t other = section; other < extents.size(); ++other) {
    if (overlap(extents[section], extents[other])) {
      near.push_back(other);
    }
  }
  return near;
}

std::vector<glm::dvec2> chain_of(const GeneratrixCurve& curve) {
  std::vector<glm::dvec2> chain;
  for (std::size_t i = 0; i < curve.sections() * k_chords; ++i) {
    chain.push_back(point_at(curve, i / k_chords, static_cast<double>(i % k_chords) / k_chords));
  }
  chain.push_back(curve.points.back());
  return chain;
}

}  // namespace

std::vector<glm::dvec2> displaced_points(const RevolutionShape& shape) {
  std::vector<glm::dvec2> points = shape.points;
  for (const Displacement& displacement : shape.displacements) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] += displacement.amount * displacement.by[i];
    }
  }
  return points;
}

GeneratrixCurve generatrix_curve(const RevolutionShape& shape,
                                 const std::vector<glm::dvec2>& points) {
  return {sections_of(points, shape.curve.value_or(GeneratrixKind::b_spline), shape.closed),
          shape.closed};
}

GeneratrixCurve generatrix_curve(const RevolutionShape& shape) {
  return generatrix_curve(shape, displaced_points(shape));
}

std::size_t section_count(const RevolutionShape& shape, std::size_t points) {
  switch (shape.curve.value_or(GeneratrixKind::b_spline)) {
    case GeneratrixKind::b_spline:
      return shape.closed ? points : points - std::min<std::size_t>(points, 3);
    case GeneratrixKind::bezier:
      return points % 3 == (shape.closed ? 0 : 1) ? points / 3 : 0;
    case GeneratrixKind::interpolating:
    case GeneratrixKind::polygon:
      break;
  }
  return shape.closed ? points : points - std::min<std::size_t>(points, 1);
}

std::size_t point_count(const RevolutionShape& shape, std::size_t sections) {
  switch (shape.curve.value_or(GeneratrixKind::b_spline)) {
    case GeneratrixKind::b_spline:
      return shape.closed ? sections : sections + 3;
    case GeneratrixKind::bezier:
      return 3 * sections + (shape.closed ? 0 : 1);
    case GeneratrixKind::interpolating:
    case GeneratrixKind::polygon:
      break;
  }
  return shape.closed ? sections : sections + 1;
}

Extent2 extent_of(const GeneratrixCurve& curve) {
  return extent_around(curve.points.data(), curve.points.data() + curve.points.size());
}

std::size_t section_beyond_axis(const GeneratrixCurve& curve) {
  const auto found = std::find_if(curve.points.begin(), curve.points.end(),
                                  [](const glm::dvec2& point) { return point.x < 0; });
  return std::min(static_cast<std::size_t>(found - curve.points.begin()) / 3, curve.sections() - 1);
}

double enclosed_area(const GeneratrixCurve& curve) {
  // Gauss's rule with three points is exact for r dz, of degree five.
  constexpr double k_nodes[] = {0.11270166537925831, 0.5, 0.8872983346207417};
  constexpr double k_weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double area = 0;
  for (std::size_t section = 0; section < curve.sections(); ++section) {
    for (int i = 0; i < 3; ++i) {
      area += k_weights[i] * point_at(curve, section, k_nodes[i]).x *
              change_at(curve, section, k_nodes[i]).y;
    }
  }
  return area;
}

std::optional<std::pair<std::size_t, std::size_t>> own_crossing(const GeneratrixCurve& curve) {
  const std::vector<glm::dvec2> chain = chain_of(curve);
  const std::vector<Extent2> extents = section_extents(curve);
  for (std::size_t section = 0; section < extents.size(); ++section) {
    const std::vector<std::size_t> near = sections_near(extents, section);
    for (std::size_t i = section * k_chords; i < (section + 1) * k_chords; ++i) {
      for (const std::size_t other : near) {
        const std::size_t end = (other + 1) * k_chords;
        for (std::size_t k = std::max(i + 2, other * k_chords); k < end; ++k) {
          if (properly_cross(chain[i], chain[i + 1], chain[k], chain[k + 1])) {
            return std::pair{section, other};
          }
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace maquette::sim
