#pragma once

#include "firmware/primitives/terrain_parameters.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/terrain_shape.hpp"

/// Every parameter of a terrain, declared once.
namespace maquette::sim {

template <class Visitor>
void declare_terrain(Visitor& visitor, TerrainShape& shape) {
  const RealType length{RealDimension::number, {0, k_largest_length, true}};
  const RealType distance{RealDimension::number, {0, k_largest_length}};
  visitor.field({"seed", "of the random displacements"}, shape.seed,
                WholeType{WholeDimension::count, {0, firmware::terrain::k_seed_end - 1}});
  visitor.field(required("levels", "of subdivision: 2 to this power cells along each edge"),
                shape.levels,
                WholeType{WholeDimension::count, {0, firmware::terrain::k_level_limit}});
  visitor.field(required("size", "edge length of the square below it"), shape.size, length);
  visitor.field(required("displacement", "up or down, greatest one of the first midpoints"),
                shape.displacement, distance);
  visitor.field({"roughness", "greatest displacement of a level over that of the one before"},
                shape.roughness, RealType{RealDimension::fraction, {0, 1}});
  visitor.field({"corners", "heights of the square's corners, two at low y, two at high y"},
                shape.corners, PointListType{{-k_largest_length, k_largest_length}});
  visitor.field(required("depth", "of the floor below z = 0"), shape.depth, distance);
}

/// The firmware's form of a shape with four corners, in units of the scene.
[[nodiscard]] firmware::terrain::Shape<double> relief_of(const TerrainShape& shape);

/// Throws DescriptionError unless there are four corners and the surface may rise above the floor.
/// `node` is the shape's.
void check_terrain(const TerrainShape& shape, const YamlNode& node);

}  // namespace maquette::sim
