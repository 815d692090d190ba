#include "sim/primitives/revolution.hpp"

#include <algorithm>

#include "firmware/primitives/generatrix_conversion.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/root_isolation.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/name_check.hpp"

namespace maquette::sim {

/// A mapping from names to displacements.
struct DisplacementsType {
  [[nodiscard]] static std::vector<Displacement> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Displacement>& displacements);
};

ChoiceType<GeneratrixKind> generatrix_kinds() {
  return {{{"b_spline", GeneratrixKind::b_spline},
           {"bezier", GeneratrixKind::bezier},
           {"interpolating", GeneratrixKind::interpolating},
           {"polygon", GeneratrixKind::polygon}}};
}

inline constexpr PointListType k_profile_points{{-k_largest_length, k_largest_length}};

template <class Visitor>
void declare(Visitor& visitor, RevolutionShape& shape) {
  visitor.field(required("points", "points [r, z] of the generatrix"), shape.points,
                k_profile_points);
  visitor.field({"curve", "what the points are; b_spline where nothing is said"}, shape.curve,
                generatrix_kinds());
  visitor.field({"closed", "the curve joins its ends; false: discs close the solid"}, shape.closed,
                FlagType{});
  visitor.field({"displacements", "of the control points, by their names"}, shape.displacements,
                DisplacementsType{});
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

namespace {

/// Throws DescriptionError unless the generatrix makes a solid: enough points and not too many, no
/// part beyond the axis, some radius and some height, no crossing of itself. `node` is the shape's.
void check_revolution(const RevolutionShape& shape, const YamlNode& node) {
  check_count(shape, node);
  const std::string moved = shape.displacements.empty() ? "" : ", displaced,";
  const GeneratrixCurve curve = generatrix_curve(shape);
  const Extent2 extent = extent_of(curve);
  if (extent.low.x < 0) {
    fail(node, "points",
         "the generatrix" + moved + " leaves the half-plane r >= 0: its section " +
             std::to_string(section_beyond_axis(curve)) +
             " has a Bezier point at r = " + format_quantity(extent.low.x, RealDimension::number));
  }
  if (!(extent.high.x > 0) || !(extent.high.y > extent.low.y) || enclosed_area(curve) == 0) {
    fail(node, "points",
         "the generatrix" + moved + " encloses nothing; some radius and some height are needed");
  }
  if (const auto crossing = own_crossing(curve)) {
    fail(node, "points",
         "the generatrix" + moved + " crosses itself: section " + std::to_string(crossing->first) +
             " meets section " + std::to_string(crossing->second));
  }
}

constexpr Recursion k_recursions[] = {
    {"revolution::intersect_node", firmware::revolution::k_tree_height + 1},
    {"revolution::write_extents", firmware::revolution::k_tree_height + 1},
    k_root_isolation};

/// The frame of points (r, z): its unit of r, and the middle and unit of z.
struct ProfileFrame {
  double radius;
  double middle;
  double half_height;
};

ProfileFrame frame_around(const Extent2& extent) {
  const double half_height = (extent.high.y - extent.low.y) / 2;
  return {extent.high.x, extent.low.y + half_height, half_height};
}

/// A unit of at least a length, at most twice as much: `unit` or two of it where that is so.
double unit_for(double length, double unit) {
  constexpr double k_rounding = 1e-12;
  for (const double multiple : {unit, 2 * unit}) {
    if (length <= multiple * (1 + k_rounding) && 2 * length > multiple) {
      return multiple;
    }
  }
  return length;
}

/// That of the points at rest, as long as the displaced ones suit it: then a board is told nothing
/// else anew than the control points that move.
ProfileFrame profile_frame(const RevolutionShape& shape) {
  const Extent2 extent = extent_of(generatrix_curve(shape));
  const ProfileFrame own = frame_around(extent);
  if (shape.displacements.empty()) {
    return own;
  }
  const ProfileFrame rest = frame_around(extent_of(generatrix_curve(shape, shape.points)));
  const double reach = std::max(extent.high.y - rest.middle, rest.middle - extent.low.y);
  const double half_height = unit_for(reach, rest.half_height);
  const double radius = unit_for(own.radius, rest.radius);
  const bool keeps_middle =
      (half_height == rest.half_height || half_height == 2 * rest.half_height) &&
      2 * own.half_height > half_height;
  return keeps_middle ? ProfileFrame{radius, rest.middle, half_height}
                      : ProfileFrame{radius, own.middle, own.half_height};
}

/// What a board is given of a generatrix, of which it converts the control points of B-splines. The
/// host makes sections of what points stand for otherwise.
std::vector<double> given_by(const RevolutionShape& shape, const ProfileFrame& frame) {
  const bool is_spline = shape.curve.value_or(GeneratrixKind::b_spline) == GeneratrixKind::b_spline;
  const GeneratrixCurve curve = generatrix_curve(shape);
  std::vector<double> given = {static_cast<double>(curve.sections()), shape.closed ? 0.0 : 1.0, 1,
                               is_spline ? 1.0 : 0.0};
  for (const glm::dvec2& point : is_spline ? displaced_points(shape) : curve.points) {
    given.insert(given.end(),
                 {point.x / frame.radius, (point.y - frame.middle) / frame.half_height});
  }
  return given;
}

}  // namespace

LocalFrame frame_of(const RevolutionShape& shape) {
  namespace revolution = firmware::revolution;
  const ProfileFrame profile = profile_frame(shape);
  LocalFrame frame;
  frame.kind = firmware::kind_of<revolution::Kind>;
  frame.given = given_by(shape, profile);
  frame.parameters.resize(static_cast<std::size_t>(
      revolution::parameter_count(static_cast<int>(generatrix_curve(shape).sections()))));
  revolution::convert(frame.given.data(), frame.parameters.data());
  frame.to_object = {profile.radius, 0, 0, 0, profile.radius, 0, 0, 0, profile.half_height, 0, 0,
                     profile.middle};
  return frame;
}

template <>
const PrimitiveDescription& description_of<firmware::revolution::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription revolution = described<RevolutionShape, check_revolution>("revolution");
    revolution.own_turns = OwnTurns::all;
    revolution.root_tolerance = firmware::revolution::k_root_tolerance;
    revolution.recursions = k_recursions;
    return revolution;
  }();
  return k_description;
}

}  // namespace maquette::sim
