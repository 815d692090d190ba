#include "sim/primitives/generatrix_description.hpp"

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"

namespace maquette::sim {

ChoiceType<GeneratrixKind> generatrix_kinds() {
  return {{{"b_spline", GeneratrixKind::b_spline},
           {"bezier", GeneratrixKind::bezier},
           {"interpolating", GeneratrixKind::interpolating},
           {"polygon", GeneratrixKind::polygon}}};
}

namespace {

template <class Visitor>
void declare_displacement(Visitor& visitor, Displacement& displacement) {
  visitor.field(required("by", "how far each control point moves, [dr, dz]"), displacement.by,
                k_profile_points);
  visitor.field({"amount", "times the displacement; 0 leaves the points where they are"},
                displacement.amount, RealType{RealDimension::number, {-1e6, 1e6}});
}

[[noreturn]] void fail(const YamlNode& node, std::string_view key, const std::string& message) {
  throw DescriptionError(nearest_node(node, key).place.position(),
                         std::string{key} + ": " + message);
}

void check_count(const RevolutionShape& shape, const YamlNode& node) {
  const GeneratrixKind kind = shape.curve.value_or(GeneratrixKind::b_spline);
  constexpr auto k_most = static_cast<std::size_t>(firmware::revolution::k_section_limit);
  const std::size_t least = shape.closed && kind != GeneratrixKind::bezier ? 3 : 1;
  const std::size_t sections = section_count(shape, shape.points.size());
  if (sections < least || sections > k_most) {
    fail(node, "points",
         std::to_string(shape.points.size()) + " control points; " +
             std::to_string(point_count(shape, least)) + " to " +
             std::to_string(point_count(shape, k_most)) + " are allowed for " +
             (shape.closed ? "a closed" : "an open") + " generatrix" +
             (kind == GeneratrixKind::bezier ? ", three for each section" : "") +
             (kind == GeneratrixKind::bezier && !shape.closed ? " and the last" : ""));
  }
  for (const Displacement& displacement : shape.displacements) {
    if (displacement.by.size() != shape.points.size()) {
      fail(node, "displacements." + displacement.name + ".by",
           std::to_string(displacement.by.size()) + " shifts for " +
               std::to_string(shape.points.size()) + " control points; as many are allowed");
    }
  }
}

}  // namespace

std::vector<Displacement> DisplacementsType::read(const YamlNode& node, std::string_view name) {
  check_mapping(node, name);
  std::vector<Displacement> displacements;
  displacements.reserve(node.entries.size());
  for (const YamlEntry& entry : node.entries) {
    check_name(entry.key, entry.place, name);
    Displacement& displacement = displacements.emplace_back();
    displacement.name = entry.key;
    FieldReader reader{entry.value, entry.key};
    declare_displacement(reader, displacement);
    reader.finish();
  }
  return displacements;
}

YamlNode DisplacementsType::write(const std::vector<Displacement>& displacements) {
  YamlNode mapping = yaml_mapping();
  for (Displacement displacement : displacements) {
    FieldWriter writer;
    declare_displacement(writer, displacement);
    append(mapping, displacement.name, writer.take());
  }
  return mapping;
}

void refuse_generatrix(const RevolutionShape& shape, const YamlNode& node,
                       const std::string& what_it_does) {
  const std::string moved = shape.displacements.empty() ? " " : ", displaced, ";
  fail(node, "points", "the generatrix" + moved + what_it_does);
}

void check_generatrix(const RevolutionShape& shape, const YamlNode& node) {
  check_count(shape, node);
  const GeneratrixCurve curve = generatrix_curve(shape);
  const Extent2 extent = extent_of(curve);
  if (extent.low.x < 0) {
    refuse_generatrix(
        shape, node,
        "leaves the half-plane r >= 0: its section " + std::to_string(section_beyond_axis(curve)) +
            " has a Bezier point at r = " + format_quantity(extent.low.x, RealDimension::number));
  }
}

}  // namespace maquette::sim
