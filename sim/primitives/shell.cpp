#include "sim/primitives/shell.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/primitives/generatrix_description.hpp"
#include "sim/primitives/generatrix_frame.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, ShellShape& shape) {
  declare_generatrix(visitor, shape.generatrix, "the curve joins its ends; false: they stay open");
}

namespace {

/// Throws DescriptionError unless the generatrix sweeps a surface: besides what is checked of any,
/// some radius and some height. `node` is the shape's.
void check_shell(const ShellShape& shape, const YamlNode& node) {
  check_generatrix(shape.generatrix, node);
  const Extent2 extent = extent_of(generatrix_curve(shape.generatrix));
  if (!(extent.high.x > 0) || !(extent.high.y > extent.low.y)) {
    refuse_generatrix(shape.generatrix, node,
                      "sweeps no more than a level ring or the axis; some radius and some height "
                      "are needed");
  }
}

std::string_view why_shells_are_opaque(const ShellShape& /*shape*/) {
  return "a shell has no thickness and holds no matter; an opaque surface is allowed, or a "
         "`revolution`, which discs close";
}

}  // namespace

LocalFrame frame_of(const ShellShape& shape) {
  return generatrix_frame(shape.generatrix, firmware::kind_of<firmware::shell::Kind>);
}

template <>
const PrimitiveDescription& description_of<firmware::shell::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription shell = described<ShellShape, check_shell, why_shells_are_opaque>(
        "shell", "{points: [[0.5, 0], [0.6, 0.5], [0.2, 1]], curve: interpolating}");
    shell.own_turns = OwnTurns::all;
    shell.root_tolerance = firmware::revolution::k_root_tolerance;
    shell.recursions = k_generatrix_recursions;
    return shell;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::shell::Kind>() {
  return listed_keys<ShellShape>();
}

}  // namespace maquette::sim
