#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/primitives/patches.hpp"

namespace maquette::sim {

/// The Bezier points of a patch: point 4 i + k is the i-th along u and the k-th along v.
using PatchNet = std::array<glm::dvec3, k_patch_points>;

/// Numbers of the points of every patch, from its list or its grid. Those of a grid must fit it.
[[nodiscard]] std::vector<PatchIndices> patch_indices(const PatchesShape& shape);

/// The patches by their Bezier points. Points of different patches that rounding alone keeps apart
/// are made one, so that common edges are the same numbers.
[[nodiscard]] std::vector<PatchNet> patch_nets(const PatchesShape& shape);

struct Extent3 {
  glm::dvec3 low;
  glm::dvec3 high;
};

/// Around the Bezier points.
[[nodiscard]] Extent3 extent_of(const std::vector<PatchNet>& nets);

/// A patch with an edge that is not shared, in the opposite direction, with exactly one other edge.
/// Edges that are collapsed to a point need no neighbour. Nothing when the set is closed.
[[nodiscard]] std::optional<std::size_t> open_patch(const std::vector<PatchNet>& nets);

/// The volume that closed patches enclose; negative when their normals point inwards.
[[nodiscard]] double enclosed_volume(const std::vector<PatchNet>& nets);

}  // namespace maquette::sim
