#include "sim/primitives/patches_fields.hpp"

#include <glm/geometric.hpp>
#include <string>

#include "firmware/primitives/patch_set.hpp"
#include "sim/primitives/patch_nets.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
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
  const bool is_bezier = shape.basis == PatchBasis::bezier;
  const std::size_t least = closed ? 3 : 4;
  const bool is_whole = !is_bezier || points % 3 == (closed ? 0 : 1);
  if (points < least || !is_whole) {
    const std::string spline = std::to_string(least) + " or more";
    fail(node, "grid",
         std::to_string(points) + " points in a " + side + "; " +
             (is_bezier ? std::string{closed ? "3, 6, 9, ..." : "4, 7, 10, ..."} : spline) +
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

}  // namespace maquette::sim
