#include "sim/primitives/sphere.hpp"

#include <optional>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

void check_radii(const SphereShape& /*shape*/, const YamlNode& node) {
  const YamlNode* radius = node.find("radius");
  const YamlNode* radii = node.find("radii");
  if ((radius == nullptr) == (radii == nullptr)) {
    throw DescriptionError((radii == nullptr ? node.place : radii->place).position(),
                           "sphere: one of radius, radii is allowed and needed");
  }
}

}  // namespace

/// A sphere gives `radius`, an ellipsoid `radii`.
template <class Visitor>
void declare(Visitor& visitor, SphereShape& shape) {
  const Vector3& radii = shape.radii;
  const bool is_round = radii.x == radii.y && radii.y == radii.z;
  std::optional<double> one;
  std::optional<Vector3> three;
  if (is_round) {
    one = radii.x;
  } else {
    three = radii;
  }
  visitor.field({"radius", "of the sphere"}, one, k_length);
  visitor.field({"radii", "of an ellipsoid, along x, y, z"}, three,
                TripleType{{0, k_largest_length, true}});
  shape.radii = three ? *three : Vector3{one.value_or(1)};
}

LocalFrame frame_of(const SphereShape& shape) {
  return {firmware::kind_of<firmware::sphere::Kind>, {}, scaled_and_raised(shape.radii, 0)};
}

template <>
const PrimitiveDescription& description_of<firmware::sphere::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription sphere = described<SphereShape, check_radii>("sphere", "{radius: 1}");
    sphere.own_turns = OwnTurns::all;
    return sphere;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::sphere::Kind>() {
  return listed_keys<SphereShape>();
}

}  // namespace maquette::sim
