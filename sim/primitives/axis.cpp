#include "sim/primitives/axis.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

[[noreturn]] void fail(const YamlNode& node, std::string_view key, const std::string& message) {
  throw DescriptionError(nearest_node(node, key).place.position(),
                         std::string{key} + ": " + message);
}

}  // namespace

void check_axis(const Axis& axis, const YamlNode& node) {
  if (axis.height && (axis.from || axis.to)) {
    fail(node, axis.from ? "from" : "to",
         "a height is given; one of height, from with to is allowed");
  }
  if (!axis.height && !(axis.from && axis.to)) {
    fail(node, axis.from ? "from" : "to", "one of height, from with to is allowed and needed");
  }
  if (axis.from && axis.from == axis.to) {
    fail(node, "to", "it is where `from` is; another point is allowed");
  }
}

double length_of(const Axis& axis) {
  return axis.height ? *axis.height : glm::length(*axis.to - *axis.from);
}

Placement placement_of(const Axis& axis) {
  if (axis.height) {
    return scaled_and_raised({1, 1, 1}, 0);
  }
  const Vector3 along = glm::normalize(*axis.to - *axis.from);
  // Any direction across: from the coordinate axis that is least along.
  const Vector3 size = glm::abs(along);
  const Vector3 other = size.x <= size.y && size.x <= size.z ? Vector3(1, 0, 0)
                        : size.y <= size.z                   ? Vector3(0, 1, 0)
                                                             : Vector3(0, 0, 1);
  const Vector3 across = glm::normalize(glm::cross(other, along));
  return {across, glm::cross(along, across), along, *axis.from};
}

}  // namespace maquette::sim
