#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "firmware/primitives/patches.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

enum class PatchBasis { bezier, b_spline };

/// Whether patches share the points where they meet, as Bezier patches do; a spline's overlap.
constexpr bool meets_at_points(PatchBasis basis) {
  switch (basis) {
    case PatchBasis::bezier:
      return true;
    case PatchBasis::b_spline:
      break;
  }
  return false;
}

/// How rays are intersected with bicubic patches: the two ways that the paper names (section II.1).
enum class PatchMethod { subdivision, roots };

/// Control points as a rectangle, row after row. A closed one joins its ends.
struct PatchGrid {
  int columns = 4;
  bool closed_rows = false;     ///< the first column follows on the last
  bool closed_columns = false;  ///< the first row follows on the last
};

inline constexpr std::size_t k_patch_points = 16;

/// Numbers of the control points of a patch, from 0 on: four rows of four.
using PatchIndices = std::vector<int>;

/// A set of bicubic patches. Either each names its points or all of them together are a grid.
struct PatchesShape {
  using Kind = firmware::patches::Kind;

  PatchBasis basis = PatchBasis::bezier;
  PatchMethod method = PatchMethod::subdivision;
  bool solid = false;  ///< false: a sheet without thickness
  std::vector<glm::dvec3> points;
  std::optional<std::vector<PatchIndices>> patches;
  std::optional<PatchGrid> grid;
};

/// A set of patches in the firmware's terms: Bezier points in [-1, 1], farther out than 0.4 along
/// one axis at least, those of a solid with normals outwards. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const PatchesShape& shape);

}  // namespace maquette::sim
