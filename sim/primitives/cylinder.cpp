#include "sim/primitives/cylinder.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, CylinderShape& shape) {
  visitor.field(required("radius", "of the cylinder"), shape.radius, k_length);
  declare_axis(visitor, shape.axis);
}

namespace {

void check_cylinder(const CylinderShape& shape, const YamlNode& node) {
  check_axis(shape.axis, node);
}

}  // namespace

LocalFrame frame_of(const CylinderShape& shape) {
  const double half_height = length_of(shape.axis) / 2;
  return {firmware::kind_of<firmware::cylinder::Kind>,
          {},
          firmware::concatenate(
              placement_of(shape.axis),
              scaled_and_raised({shape.radius, shape.radius, half_height}, half_height))};
}

template <>
const PrimitiveDescription& description_of<firmware::cylinder::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription cylinder =
        described<CylinderShape, check_cylinder>("cylinder", "{radius: 0.5, height: 1}");
    cylinder.own_turns = OwnTurns::all;
    return cylinder;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::cylinder::Kind>() {
  return listed_keys<CylinderShape>();
}

}  // namespace maquette::sim
