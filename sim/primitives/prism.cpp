#include "sim/primitives/prism.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "firmware/primitives/prism_outline.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/field_reader.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/primitives/prism_edges.hpp"
#include "sim/primitives/root_isolation.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

/// A list of contours, each a `polygon` by its corners or a `spline` by its control points.
struct ContourListType {
  [[nodiscard]] static std::vector<Contour> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Contour>& contours);
};

template <class Visitor>
void declare(Visitor& visitor, PrismShape& shape) {
  visitor.field(required("contours",
                         "a list of polygon: [[x, y], ...] or spline: [[x, y], ...]; "
                         "filled where a line has crossed an odd number of them"),
                shape.contours, ContourListType{});
  visitor.field(required("height", "along z"), shape.height,
                RealType{RealDimension::number, {0, k_largest_length, true}});
}
namespace {

constexpr PointListType k_points{{-k_largest_length, k_largest_length}};

/// Share of the area of the contours' rectangle below which they enclose nothing.
constexpr double k_least_area = 1e-9;

[[noreturn]] void fail(const YamlNode& node, std::string_view name, const std::string& message) {
  throw DescriptionError(node.place.position(), std::string{name} + ": " + message);
}

Contour read_contour(const YamlNode& node, std::string_view name) {
  const bool is_single = node.kind == YamlKind::mapping && node.entries.size() == 1;
  const std::string key = is_single ? node.entries[0].key : "";
  if (key != "polygon" && key != "spline") {
    fail(node, name, "one of polygon, spline is allowed and needed");
  }
  const YamlEntry& entry = node.entries[0];
  Contour contour;
  contour.curved = key == "spline";
  contour.points = k_points.read(entry.value, key);
  if (contour.points.size() < 3) {
    fail(entry.value, key,
         std::to_string(contour.points.size()) + " points; three or more are allowed");
  }
  return contour;
}

bool has_area(const PrismEdges& edges) {
  if (crossing_count(edges) == 0) {
    return false;
  }
  const PlaneBox box = box_of(edges);
  const glm::dvec2 size = box.high - box.low;
  return enclosed_area(edges) > k_least_area * size.x * size.y;
}

}  // namespace

std::vector<Contour> ContourListType::read(const YamlNode& node, std::string_view name) {
  if (node.kind != YamlKind::sequence || node.items.empty()) {
    fail(node, name, node.kind_name() + " stands here; a list of contours is allowed");
  }
  std::vector<Contour> contours;
  contours.reserve(node.items.size());
  for (const YamlNode& item : node.items) {
    contours.push_back(read_contour(item, name));
  }
  return contours;
}

YamlNode ContourListType::write(const std::vector<Contour>& contours) {
  std::vector<YamlNode> items;
  items.reserve(contours.size());
  for (const Contour& contour : contours) {
    YamlNode item = yaml_mapping();
    append(item, contour.curved ? "spline" : "polygon", PointListType::write(contour.points));
    items.push_back(std::move(item));
  }
  return yaml_sequence(std::move(items));
}

namespace {

/// Throws DescriptionError unless the contours make a solid: three points each, some area, no more
/// edges than a prism may have. `node` is the shape's.
void check_prism(const PrismShape& shape, const YamlNode& node) {
  const YamlNode& contours = nearest_node(node, "contours");
  constexpr int k_limit = firmware::prism::k_crossing_limit;
  std::size_t crossings = 0;
  for (const Contour& contour : shape.contours) {
    crossings += contour.points.size() * (contour.curved ? 3 : 1);
  }
  const auto check_count = [&](std::size_t count, const std::string& when) {
    if (count > k_limit) {
      fail(contours, "contours",
           std::to_string(count) + " crossings of a line are possible" + when + "; up to " +
               std::to_string(k_limit) +
               " are allowed: one for each side of a polygon, three for each point of a spline");
    }
  };
  check_count(crossings, "");
  const PrismEdges edges = prism_edges(shape);
  check_count(crossing_count(edges), ", edges cut where they cross");
  if (!has_area(edges)) {
    fail(contours, "contours", "they enclose nothing; some area is needed");
  }
}

constexpr Recursion k_recursions[] = {{"prism::cross_node", firmware::prism::k_tree_height + 1},
                                      k_root_isolation};

}  // namespace

LocalFrame frame_of(const PrismShape& shape) {
  PrismEdges edges = prism_edges(shape);
  const PlaneBox box = box_of(edges);
  const glm::dvec2 half = (box.high - box.low) / 2.0;
  const glm::dvec2 middle = box.low + half;
  for (std::vector<Edge>* list : {&edges.lines, &edges.cubics}) {
    for (Edge& edge : *list) {
      for (glm::dvec2& point : edge.points) {
        point = (point - middle) / half;
      }
    }
  }
  LocalFrame frame;
  frame.kind = firmware::kind_of<firmware::prism::Kind>;
  frame.parameters = outline_parameters(edges);
  const double half_height = shape.height / 2;
  frame.to_object = {half.x, 0, 0,           0,        half.y,   0,
                     0,      0, half_height, middle.x, middle.y, half_height};
  return frame;
}

template <>
const PrimitiveDescription& description_of<firmware::prism::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription prism = described<PrismShape, check_prism>(
        "prism", "{height: 1, contours: [{polygon: [[0, 0], [1, 0], [0, 1]]}]}");
    prism.recursions = k_recursions;
    return prism;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::prism::Kind>() {
  return listed_keys<PrismShape>();
}

}  // namespace maquette::sim
