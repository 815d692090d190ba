#pragma once

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/prism_shape.hpp"

/// Every parameter of a prism, declared once.
namespace maquette::sim {

/// A list of contours, each a `polygon` by its corners or a `spline` by its control points.
struct ContourListType {
  [[nodiscard]] static std::vector<Contour> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Contour>& contours);
};

template <class Visitor>
void declare_prism(Visitor& visitor, PrismShape& shape) {
  visitor.field(required("contours",
                         "a list of polygon: [[x, y], ...] or spline: [[x, y], ...]; "
                         "filled where a line has crossed an odd number of them"),
                shape.contours, ContourListType{});
  visitor.field(required("height", "along z"), shape.height,
                RealType{RealDimension::number, {0, k_largest_length, true}});
}

/// Throws DescriptionError unless the contours make a solid: three points each, some area, no more
/// edges than a prism may have. `node` is the shape's.
void check_prism(const PrismShape& shape, const YamlNode& node);

}  // namespace maquette::sim
