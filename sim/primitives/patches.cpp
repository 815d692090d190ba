#include "sim/primitives/patches.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/patch_nets.hpp"
#include "sim/primitives/patch_order.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/yaml/description_error.hpp"

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
void declare(Visitor& visitor, PatchesShape& shape) {
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
namespace {

constexpr TripleType k_place{{-k_largest_length, k_largest_length}};
constexpr WholeType k_point_number{WholeDimension::count, {0, 1'000'000}};

[[noreturn]] void fail(const YamlNode& node, std::string_view name, const std::string& message) {
  throw DescriptionError(node.place.position(), std::string{name} + ": " + message);
}

const YamlNode& list(const YamlNode& node, std::string_view name, const std::string& what) {
  if (node.kind != YamlKind::sequence || node.items.empty()) {
    fail(node, name, node.kind_name() + " stands here; a list of " + what + " is allowed");
  }
  return node;
}

std::string range_of_points(const PatchesShape& shape) {
  return "0 to " + std::to_string(shape.points.size() - 1) + " are allowed";
}

void check_numbers(const PatchesShape& shape, const YamlNode& node) {
  const YamlNode& written = nearest_node(node, "patches");
  for (std::size_t i = 0; i < shape.patches->size(); ++i) {
    const PatchIndices& indices = (*shape.patches)[i];
    for (std::size_t k = 0; k < indices.size(); ++k) {
      if (static_cast<std::size_t>(indices[k]) >= shape.points.size()) {
        fail(written.items[i].items[k], "patches",
             "there is no point " + std::to_string(indices[k]) + "; " + range_of_points(shape));
      }
    }
  }
}

/// Points along one side of a grid: enough, and for Bezier points as many as whole patches have.
void check_side(const PatchesShape& shape, const YamlNode& node, std::size_t points, bool closed,
                const std::string& side) {
  const bool counts_by_patches = meets_at_points(shape.basis);
  const std::size_t least = closed ? 3 : 4;
  const bool is_whole = !counts_by_patches || points % 3 == (closed ? 0 : 1);
  if (points < least || !is_whole) {
    const std::string spline = std::to_string(least) + " or more";
    fail(node, "grid",
         std::to_string(points) + " points in a " + side + "; " +
             (counts_by_patches ? std::string{closed ? "3, 6, 9, ..." : "4, 7, 10, ..."} : spline) +
             " are allowed for " + (closed ? "a closed " : "an open ") + side);
  }
}

void check_grid(const PatchesShape& shape, const YamlNode& node) {
  const YamlNode& written = nearest_node(node, "grid");
  const auto columns = static_cast<std::size_t>(shape.grid->columns);
  if (shape.points.size() % columns != 0) {
    fail(written, "grid",
         std::to_string(shape.points.size()) + " points do not make whole rows of " +
             std::to_string(columns));
  }
  check_side(shape, written, columns, shape.grid->closed_rows, "row");
  check_side(shape, written, shape.points.size() / columns, shape.grid->closed_columns, "column");
}

void check_solid(const std::vector<PatchNet>& nets, const YamlNode& node) {
  const YamlNode& patches = nearest_node(node, "patches");
  if (const auto open = open_patch(nets)) {
    const bool is_listed = patches.kind == YamlKind::sequence;
    fail(
        is_listed ? patches.items[*open] : node, "solid",
        "patch " + std::to_string(*open) +
            " has an edge whose four points are not those of exactly one other edge, the other way "
            "round; a closed set is needed, or `solid: false`");
  }
  const Extent3 extent = extent_of(nets);
  const double size = glm::length(extent.high - extent.low);
  constexpr double k_least_share = 1e-12;
  if (!(std::abs(enclosed_volume(nets)) > k_least_share * size * size * size)) {
    fail(node, "solid", "the patches enclose nothing");
  }
}

}  // namespace

std::vector<glm::dvec3> SpacePointListType::read(const YamlNode& node, std::string_view name) {
  std::vector<glm::dvec3> points;
  for (const YamlNode& item : list(node, name, "points [x, y, z]").items) {
    points.push_back(k_place.read(item, name));
  }
  return points;
}

YamlNode SpacePointListType::write(const std::vector<glm::dvec3>& points) {
  std::vector<YamlNode> items;
  items.reserve(points.size());
  for (const glm::dvec3& point : points) {
    items.push_back(TripleType::write(point));
  }
  return yaml_sequence(std::move(items));
}

std::vector<PatchIndices> PatchListType::read(const YamlNode& node, std::string_view name) {
  std::vector<PatchIndices> patches;
  for (const YamlNode& item : list(node, name, "patches").items) {
    if (item.kind != YamlKind::sequence || item.items.size() != k_patch_points) {
      const bool is_list = item.kind == YamlKind::sequence;
      fail(item, name,
           (is_list ? std::to_string(item.items.size()) + " numbers stand here"
                    : item.kind_name() + " stands here") +
               "; a list of 16 numbers of points is allowed");
    }
    PatchIndices& indices = patches.emplace_back();
    for (const YamlNode& number : item.items) {
      indices.push_back(static_cast<int>(k_point_number.read(number, name)));
    }
  }
  return patches;
}

YamlNode PatchListType::write(const std::vector<PatchIndices>& patches) {
  std::vector<YamlNode> items;
  for (const PatchIndices& indices : patches) {
    std::vector<YamlNode> numbers;
    for (const int index : indices) {
      numbers.push_back(k_point_number.write(index));
    }
    items.push_back(yaml_sequence(std::move(numbers)));
  }
  return yaml_sequence(std::move(items));
}

namespace {

/// Throws DescriptionError unless the patches are there: each of 16 points that exist, not too
/// many, not all in one point; closed if they bound a solid. `node` is the shape's.
void check_patches(const PatchesShape& shape, const YamlNode& node) {
  if (shape.patches.has_value() == shape.grid.has_value()) {
    fail(shape.grid ? nearest_node(node, "grid") : node, "patches",
         "one of patches, grid is allowed and needed");
  }
  if (shape.patches) {
    check_numbers(shape, node);
  } else {
    check_grid(shape, node);
  }
  const std::vector<PatchNet> nets = patch_nets(shape);
  constexpr std::size_t k_most = firmware::patches::k_patch_limit;
  if (nets.size() > k_most) {
    fail(node, "patches",
         std::to_string(nets.size()) + " patches; 1 to " + std::to_string(k_most) +
             " are allowed in one object, more in a union");
  }
  const Extent3 extent = extent_of(nets);
  if (extent.low == extent.high) {
    fail(nearest_node(node, "points"), "points", "all control points are one point");
  }
  if (shape.solid) {
    check_solid(nets, node);
  }
}

/// Without thickness they hold no matter.
std::string_view why_sheets_are_opaque(const PatchesShape& shape) {
  return shape.solid ? std::string_view{}
                     : "patches without thickness hold no matter; an opaque surface or "
                       "`solid: true` is allowed";
}

constexpr Recursion k_recursions[] = {
    {"patches::intersect_node", firmware::patches::k_tree_height + 1},
    {"patches::write_boxes", firmware::patches::k_tree_height + 1},
    {"patches::isolate", firmware::patches::k_cell_bisection_limit<float> + 1},
    {"patches::crossings_of", firmware::patches::k_edge_bisection_limit<float> + 1}};

firmware::patches::SearchMethod::Value search_method_of(PatchMethod method) {
  switch (method) {
    case PatchMethod::roots:
      return firmware::patches::SearchMethod::roots;
    case PatchMethod::subdivision:
      break;
  }
  return firmware::patches::SearchMethod::subdivision;
}

/// The frame of a net: its middle and its unit.
struct NetFrame {
  glm::dvec3 middle;
  double unit;
};

/// In which Bezier points lie in [-1, 1]. The unit is a power of two and the middle goes in steps
/// of a quarter of it, so that a net keeps its frame when points of it move a little: then a board
/// is told nothing else anew than the coordinates that move.
NetFrame net_frame(const Extent3& extent) {
  constexpr double k_steps = 4;
  constexpr double k_room = 1 + 1 / (2 * k_steps - 1);  // for the middle, half a step aside
  const glm::dvec3 half = (extent.high - extent.low) * 0.5;
  const double unit = std::exp2(std::ceil(std::log2(std::max({half.x, half.y, half.z}) * k_room)));
  const double step = unit / k_steps;
  return {glm::round((extent.low + half) / step) * step, unit};
}

/// The numbers of a patch's points with u and v exchanged: its normals point the other way.
PatchIndices turned_over(const PatchIndices& indices) {
  PatchIndices turned;
  for (std::size_t i = 0; i < k_patch_points; ++i) {
    turned.push_back(indices[4 * (i % 4) + i / 4]);
  }
  return turned;
}

/// What a board is given of a net.
std::vector<double> given_by(const PatchesShape& shape, const std::vector<PatchNet>& nets,
                             const NetFrame& frame) {
  std::vector<double> given = {
      static_cast<double>(nets.size()), shape.solid ? 1.0 : 0.0,
      firmware::patches::narrows(search_method_of(shape.method)) ? 1.0 : 0.0,
      meets_at_points(shape.basis) ? 0.0 : 1.0, static_cast<double>(shape.points.size())};
  for (const glm::dvec3& point : shape.points) {
    const glm::dvec3 local = (point - frame.middle) / frame.unit;
    given.insert(given.end(), {local.x, local.y, local.z});
  }
  const bool is_inside_out = shape.solid && enclosed_volume(nets) < 0;
  const std::vector<PatchIndices> indices = patch_indices(shape);
  for (const std::size_t patch : patch_order(nets)) {
    const PatchIndices own = is_inside_out ? turned_over(indices[patch]) : indices[patch];
    given.insert(given.end(), own.begin(), own.end());
  }
  return given;
}

}  // namespace

LocalFrame frame_of(const PatchesShape& shape) {
  namespace patches = firmware::patches;
  const std::vector<PatchNet> nets = patch_nets(shape);
  const NetFrame net = net_frame(extent_of(nets));
  LocalFrame frame;
  frame.kind = firmware::kind_of<patches::Kind>;
  frame.given = given_by(shape, nets, net);
  frame.parameters.resize(
      static_cast<std::size_t>(patches::parameter_count(static_cast<int>(nets.size()))));
  patches::convert(frame.given.data(), frame.parameters.data());
  frame.to_object = {net.unit,     0,           0, 0, net.unit, 0, 0, 0, net.unit, net.middle.x,
                     net.middle.y, net.middle.z};
  return frame;
}

template <>
const PrimitiveDescription& description_of<firmware::patches::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription patches = described<PatchesShape, check_patches, why_sheets_are_opaque>(
        "patches",
        "{basis: b_spline, grid: {columns: 4}, points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, "
        "0], [0, 1, 0], [1, 1, 1], [2, 1, 1], [3, 1, 0], [0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, "
        "0], [0, 3, 0], [1, 3, 0], [2, 3, 0], [3, 3, 0]]}");
    patches.recursions = k_recursions;
    return patches;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::patches::Kind>() {
  return listed_keys<PatchesShape>();
}

}  // namespace maquette::sim
