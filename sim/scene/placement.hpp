#pragma once

#include <string>
#include <string_view>

#include "sim/scene/scene.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The placement that first applies `inner` and then `outer`.
[[nodiscard]] Placement concatenated(const Placement& outer, const Placement& inner);

/// The inverse of an affine placement that is not singular.
[[nodiscard]] Placement inverse_of(const Placement& placement);

/// Whether a placement flattens space, or so nearly that its inverse would be noise: its
/// determinant is below 1e-12 of the product of its columns' lengths; also when one of its elements
/// is beyond 1e30 or no number.
[[nodiscard]] bool is_singular(const Placement& placement);

/// Reads a list of steps, applied in their order, or a single step: `{translate: [x, y, z]}`,
/// `{scale: s}` or `{scale: [x, y, z]}`, `{rotate: {axis: [x, y, z], angle: 30 deg}}`,
/// `{matrix: [12 numbers]}`, the rows of a 3x4 matrix. Throws DescriptionError, also for placements
/// that cannot be undone.
[[nodiscard]] Placement read_placement(const YamlNode& node);

/// The placement as a single `matrix` step, which reads back exactly.
[[nodiscard]] YamlNode write_placement(const Placement& placement);

/// The type of a field that is a placement.
struct PlacementType {
  [[nodiscard]] static Placement read(const YamlNode& node, std::string_view /*name*/) {
    return read_placement(node);
  }
  [[nodiscard]] static YamlNode write(const Placement& placement) {
    return write_placement(placement);
  }
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "steps: translate, scale, rotate, matrix"; }
};

}  // namespace maquette::sim
