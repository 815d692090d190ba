#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sim/primitives/revolution.hpp"

namespace maquette::sim {

/// The generatrix of a solid of revolution as a chain of cubic Bezier sections: three points (r, z)
/// for each section and the last.
struct GeneratrixCurve {
  std::vector<glm::dvec2> points;
  bool closed = false;

  [[nodiscard]] std::size_t sections() const { return points.size() / 3; }
};

/// The smallest and the largest coordinates of Bezier points.
struct Extent2 {
  glm::dvec2 low;
  glm::dvec2 high;
};

/// The sections that a shape's points make (paper, section IV.2.1: change of basis); as many points
/// as displaced_points gives. Their number must be a generatrix's.
[[nodiscard]] GeneratrixCurve generatrix_curve(const RevolutionShape& shape,
                                               const std::vector<glm::dvec2>& points);

/// The same after all displacements.
[[nodiscard]] GeneratrixCurve generatrix_curve(const RevolutionShape& shape);

/// So many sections are made of so many points; 0 where that is not a whole number of them.
[[nodiscard]] std::size_t section_count(const RevolutionShape& shape, std::size_t points);

/// So many points make so many sections.
[[nodiscard]] std::size_t point_count(const RevolutionShape& shape, std::size_t sections);

[[nodiscard]] Extent2 extent_of(const GeneratrixCurve& curve);

/// The first section with a Bezier point at r < 0, counted from 0.
[[nodiscard]] std::size_t section_beyond_axis(const GeneratrixCurve& curve);

/// The area between the curve, closed where it is open by lines to the axis, and the axis; negative
/// when the solid is on its right.
[[nodiscard]] double enclosed_area(const GeneratrixCurve& curve);

/// Two sections that cross each other, or a section that crosses itself; from chords, 16 to a
/// section, so that what crosses by less than a chord's sagitta is let through.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> own_crossing(
    const GeneratrixCurve& curve);

}  // namespace maquette::sim
