#include "sim/primitives/box.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, BoxShape& shape) {
  visitor.field(required("size", "edge lengths along x, y, z"), shape.size,
                TripleType{{0, k_largest_length, true}, true});
}

LocalFrame frame_of(const BoxShape& shape) {
  return {firmware::kind_of<firmware::box::Kind>, {}, scaled_and_raised(shape.size / 2.0, 0)};
}

template <>
const PrimitiveDescription& description_of<firmware::box::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription box = described<BoxShape>("box", "{size: [1, 2, 0.5]}");
    box.own_turns = OwnTurns::quarters;
    return box;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::box::Kind>() {
  return listed_keys<BoxShape>();
}

}  // namespace maquette::sim
