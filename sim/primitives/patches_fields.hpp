#pragma once

#include <optional>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/patches_shape.hpp"

/// Every parameter of a set of patches, declared once.
namespace maquette::sim {

/// A list of points in space.
struct SpacePointListType {
  [[nodiscard]] static std::vector<glm::dvec3> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<glm::dvec3>& points);
};

/// Lists of 16 numbers of points.
struct PatchListType {
  [[nodiscard]] static std::vector<PatchIndices> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<PatchIndices>& patches);
};

template <class Visitor>
void declare_patch_grid(Visitor& visitor, PatchGrid& grid) {
  visitor.field(required("columns", "points in a row"), grid.columns,
                WholeType{WholeDimension::count, {3, 1000}});
  visitor.field({"closed_rows", "the first column follows on the last"}, grid.closed_rows,
                FlagType{});
  visitor.field({"closed_columns", "the first row follows on the last"}, grid.closed_columns,
                FlagType{});
}

template <class Visitor>
void declare_patches(Visitor& visitor, PatchesShape& shape) {
  visitor.field(
      {"basis", "of the bicubics: what the control points mean"}, shape.basis,
      ChoiceType<PatchBasis>{{{"bezier", PatchBasis::bezier}, {"b_spline", PatchBasis::b_spline}}});
  visitor.field({"method", "of intersection: halving of the patches, or roots of their equations"},
                shape.method,
                ChoiceType<PatchMethod>{
                    {{"subdivision", PatchMethod::subdivision}, {"roots", PatchMethod::roots}}});
  visitor.field(
      {"solid", "the patches are closed and bound a solid; false: they have no thickness"},
      shape.solid, FlagType{});
  visitor.field(required("points", "control points"), shape.points, SpacePointListType{});
  visitor.field({"patches", "numbers of the 16 points of each, from 0 on; or give a grid"},
                shape.patches, PatchListType{});
  bool has_grid = shape.grid.has_value();
  PatchGrid grid = shape.grid.value_or(PatchGrid{});
  visitor.optional_group({"grid", "the points are a rectangle, row after row; or give patches"},
                         has_grid, [&] { declare_patch_grid(visitor, grid); });
  if (has_grid) {
    shape.grid = grid;
  }
}

/// Throws DescriptionError unless the patches are there: each of 16 points that exist, not too
/// many, not all in one point; closed if they bound a solid. `node` is the shape's.
void check_patches(const PatchesShape& shape, const YamlNode& node);

}  // namespace maquette::sim
