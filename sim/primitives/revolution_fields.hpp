#pragma once

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/revolution_shape.hpp"

/// Every parameter of a solid of revolution, declared once.
namespace maquette::sim {

/// A mapping from names to displacements.
struct DisplacementsType {
  [[nodiscard]] static std::vector<Displacement> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Displacement>& displacements);
};

inline constexpr PointListType k_profile_points{{-k_largest_length, k_largest_length}};

template <class Visitor>
void declare_revolution(Visitor& visitor, RevolutionShape& shape) {
  visitor.field(required("points", "control points [r, z] of a uniform cubic B-spline"),
                shape.points, k_profile_points);
  visitor.field({"closed", "the spline joins its ends; false: discs close the solid"}, shape.closed,
                FlagType{});
  visitor.field({"displacements", "of the control points, by their names"}, shape.displacements,
                DisplacementsType{});
}

/// Throws DescriptionError unless the generatrix makes a solid: enough points and not too many, no
/// part beyond the axis, some radius and some height, no crossing of itself. `node` is the shape's.
void check_revolution(const RevolutionShape& shape, const YamlNode& node);

}  // namespace maquette::sim
