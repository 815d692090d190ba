#include "sim/primitives/half_space.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& /*visitor*/, HalfSpaceShape& /*shape*/) {}

LocalFrame frame_of(const HalfSpaceShape& /*shape*/) {
  return {firmware::kind_of<firmware::half_space::Kind>, {}, Placement(1.0)};
}

template <>
const PrimitiveDescription& description_of<firmware::half_space::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription half_space = described<HalfSpaceShape>("half_space", "{}");
    half_space.own_turns = OwnTurns::all;
    return half_space;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::half_space::Kind>() {
  return listed_keys<HalfSpaceShape>();
}

}  // namespace maquette::sim
