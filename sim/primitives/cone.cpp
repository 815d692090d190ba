#include "sim/primitives/cone.hpp"

#include <algorithm>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/cylinder.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, ConeShape& shape) {
  visitor.field(required("radius", "at z = 0 or from"), shape.radius, k_length);
  visitor.field({"top_radius", "at z = height or to; 0 is a pointed cone"}, shape.top_radius,
                RealType{RealDimension::number, {0, k_largest_length}});
  declare_axis(visitor, shape.axis);
}

namespace {

void check_cone(const ConeShape& shape, const YamlNode& node) { check_axis(shape.axis, node); }

}  // namespace

LocalFrame frame_of(const ConeShape& shape) {
  // The canonical cone has its apex at the origin and its base, of radius 1, at z = 1.
  const double wide = std::max(shape.radius, shape.top_radius);
  const double narrow = std::min(shape.radius, shape.top_radius);
  if (wide == narrow) {
    return frame_of(CylinderShape{wide, shape.axis});
  }
  const double height = length_of(shape.axis);
  const double ratio = narrow / wide;
  const double apex_height = height / (1 - ratio);
  const bool stands_on_base = shape.radius > shape.top_radius;
  const Placement frame = stands_on_base
                              ? scaled_and_raised({wide, wide, -apex_height}, apex_height)
                              : scaled_and_raised({wide, wide, apex_height}, height - apex_height);
  return {firmware::kind_of<firmware::cone::Kind>,
          {ratio},
          firmware::concatenate(placement_of(shape.axis), frame)};
}

template <>
const PrimitiveDescription& description_of<firmware::cone::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription cone =
        described<ConeShape, check_cone>("cone", "{radius: 0.5, height: 1}");
    cone.own_turns = OwnTurns::all;
    return cone;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::cone::Kind>() {
  return listed_keys<ConeShape>();
}

}  // namespace maquette::sim
