#include "sim/primitives/torus.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/primitives/root_isolation.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, TorusShape& shape) {
  visitor.field(required("major_radius", "from the axis, z, to the middle of the tube"),
                shape.major_radius, k_length);
  visitor.field(required("minor_radius", "of the tube; smaller than major_radius"),
                shape.minor_radius, k_length);
}

namespace {

void check_radii(const TorusShape& shape, const YamlNode& node) {
  if (shape.minor_radius >= shape.major_radius) {
    throw DescriptionError(
        nearest_node(node, "minor_radius").place.position(),
        "minor_radius: " + format_quantity(shape.minor_radius, RealDimension::number) +
            " leaves no hole; less than major_radius, " +
            format_quantity(shape.major_radius, RealDimension::number) + ", is allowed");
  }
}

constexpr Recursion k_recursions[] = {k_root_isolation};

}  // namespace

LocalFrame frame_of(const TorusShape& shape) {
  const double outer = shape.major_radius + shape.minor_radius;
  return {firmware::kind_of<firmware::torus::Kind>,
          {shape.minor_radius / outer, 1},
          scaled_and_raised({outer, outer, outer}, 0)};
}

template <>
const PrimitiveDescription& description_of<firmware::torus::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription torus =
        described<TorusShape, check_radii>("torus", "{major_radius: 1, minor_radius: 0.3}");
    torus.own_turns = OwnTurns::all;
    torus.root_tolerance = firmware::torus::k_root_tolerance;
    torus.recursions = k_recursions;
    return torus;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::torus::Kind>() {
  return listed_keys<TorusShape>();
}

}  // namespace maquette::sim
