#include "sim/primitives/revolution.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/primitives/generatrix_description.hpp"
#include "sim/primitives/generatrix_frame.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, RevolutionShape& shape) {
  declare_generatrix(visitor, shape, "the curve joins its ends; false: discs close the solid");
}

namespace {

/// Throws DescriptionError unless the generatrix makes a solid: besides what is checked of any,
/// some radius and some height, no crossing of itself. `node` is the shape's.
void check_revolution(const RevolutionShape& shape, const YamlNode& node) {
  check_generatrix(shape, node);
  const GeneratrixCurve curve = generatrix_curve(shape);
  const Extent2 extent = extent_of(curve);
  if (!(extent.high.x > 0) || !(extent.high.y > extent.low.y) || enclosed_area(curve) == 0) {
    refuse_generatrix(shape, node, "encloses nothing; some radius and some height are needed");
  }
  if (const auto crossing = own_crossing(curve)) {
    refuse_generatrix(shape, node,
                      "crosses itself: section " + std::to_string(crossing->first) +
                          " meets section " + std::to_string(crossing->second));
  }
}

}  // namespace

LocalFrame frame_of(const RevolutionShape& shape) {
  return generatrix_frame(shape, firmware::kind_of<firmware::revolution::Kind>);
}

template <>
const PrimitiveDescription& description_of<firmware::revolution::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription revolution = described<RevolutionShape, check_revolution>(
        "revolution", "{points: [[0.5, 0], [0.6, 0.5], [0.2, 1]], curve: interpolating}");
    revolution.own_turns = OwnTurns::all;
    revolution.root_tolerance = firmware::revolution::k_root_tolerance;
    revolution.recursions = k_generatrix_recursions;
    return revolution;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::revolution::Kind>() {
  return listed_keys<RevolutionShape>();
}

}  // namespace maquette::sim
