#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/revolution.hpp"
#include "sim/primitives/root_isolation.hpp"

/// What descriptions of the primitives that have a generatrix share.
namespace maquette::sim {

/// A mapping from names to displacements.
struct DisplacementsType {
  [[nodiscard]] static std::vector<Displacement> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Displacement>& displacements);
};

[[nodiscard]] ChoiceType<GeneratrixKind> generatrix_kinds();

inline constexpr PointListType k_profile_points{{-k_largest_length, k_largest_length}};

/// Declares the fields of a generatrix; `closed` says what it is to be closed.
template <class Visitor>
void declare_generatrix(Visitor& visitor, RevolutionShape& shape, std::string_view closed) {
  visitor.field(required("points", "points [r, z] of the generatrix"), shape.points,
                k_profile_points);
  visitor.field(
      {"curve",
       "what the points are; b_spline where nothing is said, whose open curve does not reach "
       "the end points"},
      shape.curve, generatrix_kinds());
  visitor.field({"closed", closed}, shape.closed, FlagType{});
  visitor.field({"displacements", "of the control points, by their names"}, shape.displacements,
                DisplacementsType{});
}

/// Throws DescriptionError that says of the generatrix that it does what it may not do.
[[noreturn]] void refuse_generatrix(const RevolutionShape& shape, const YamlNode& node,
                                    const std::string& what_it_does);

/// Throws DescriptionError unless a generatrix has enough points and not too many, no part beyond
/// the axis, and displacements of all its points. `node` is the shape's.
void check_generatrix(const RevolutionShape& shape, const YamlNode& node);

/// Of what is intersected with the sections of a generatrix, and of their conversion.
inline constexpr Recursion k_generatrix_recursions[] = {
    {"revolution::intersect_node", firmware::revolution::k_tree_height + 1},
    {"revolution::write_extents", firmware::revolution::k_tree_height + 1},
    k_root_isolation};

}  // namespace maquette::sim
