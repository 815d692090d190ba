#pragma once

#include <optional>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/local_frame.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// The axis of a cylinder or cone: from the origin along z, or between two points.
struct Axis {
  std::optional<double> height = std::nullopt;
  std::optional<Vector3> from = std::nullopt;
  std::optional<Vector3> to = std::nullopt;
};

template <class Visitor>
void declare_axis(Visitor& visitor, Axis& axis) {
  constexpr TripleType k_place{{-k_largest_length, k_largest_length}};
  visitor.field({"height", "along z; or give from and to"}, axis.height, k_length);
  visitor.field({"from", "the middle of one end; or give a height"}, axis.from, k_place);
  visitor.field({"to", "the middle of the other end"}, axis.to, k_place);
}

/// Throws DescriptionError unless it is one or the other and has a length. `node` is the shape's.
void check_axis(const Axis& axis, const YamlNode& node);

/// Of a checked axis.
[[nodiscard]] double length_of(const Axis& axis);

/// Takes a solid that stands on the origin along z, as high as the axis is long, to the axis.
[[nodiscard]] Placement placement_of(const Axis& axis);

}  // namespace maquette::sim
