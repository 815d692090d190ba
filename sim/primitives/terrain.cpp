#include "sim/primitives/terrain.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/primitives/primitive_table.hpp"
#include "firmware/primitives/terrain_parameters.hpp"
#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/primitives/primitive_description.hpp"
#include "sim/primitives/primitive_keys.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

template <class Visitor>
void declare(Visitor& visitor, TerrainShape& shape) {
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

namespace {

[[noreturn]] void fail(const YamlNode& node, std::string_view key, const std::string& message) {
  throw DescriptionError(nearest_node(node, key).place.position(),
                         std::string{key} + ": " + message);
}

/// The firmware's form of a shape with four corners, in units of the scene.
firmware::terrain::Shape<double> relief_of(const TerrainShape& shape) {
  const glm::dvec2& low = shape.corners[0];
  const glm::dvec2& high = shape.corners[1];
  return {shape.levels,       shape.seed,     -shape.depth, {low.x, low.y, high.x, high.y},
          shape.displacement, shape.roughness};
}

/// Throws DescriptionError unless there are four corners and the surface may rise above the floor.
/// `node` is the shape's.
void check_terrain(const TerrainShape& shape, const YamlNode& node) {
  if (shape.corners.size() != 2) {
    fail(node, "corners",
         std::to_string(shape.corners.size()) +
             " pairs of heights; two are allowed, at low y and at high y");
  }
  if (!(firmware::terrain::top_of(relief_of(shape)) > -shape.depth)) {
    fail(node, "depth", "the terrain lies all below its floor; a deeper one is allowed");
  }
}

constexpr Recursion k_recursions[] = {
    {"terrain::follow_over", firmware::terrain::k_level_limit + 1}};

}  // namespace

LocalFrame frame_of(const TerrainShape& shape) {
  firmware::terrain::Shape<double> scaled = relief_of(shape);
  const double height = std::max(std::fabs(firmware::terrain::top_of(scaled)), shape.depth);
  scaled.floor /= height;
  scaled.displacement /= height;
  for (double& corner : scaled.corners) {
    corner /= height;
  }
  LocalFrame frame;
  frame.kind = firmware::kind_of<firmware::terrain::Kind>;
  const auto* c = scaled.corners;
  frame.given = {static_cast<double>(scaled.levels),
                 static_cast<double>(scaled.seed),
                 scaled.floor,
                 c[0],
                 c[1],
                 c[2],
                 c[3],
                 scaled.displacement,
                 scaled.roughness};
  frame.parameters.resize(
      static_cast<std::size_t>(firmware::terrain::parameter_count(shape.levels)));
  firmware::terrain::convert(frame.given.data(), frame.parameters.data());
  const double middle = -shape.size / 2;
  frame.to_object = {shape.size, 0, 0, 0, shape.size, 0, 0, 0, height, middle, middle, 0};
  return frame;
}

template <>
const PrimitiveDescription& description_of<firmware::terrain::Kind>() {
  static constexpr PrimitiveDescription k_description = [] {
    PrimitiveDescription terrain = described<TerrainShape, check_terrain>(
        "terrain", "{levels: 4, size: 2, displacement: 0.3, depth: 0.5}");
    terrain.recursions = k_recursions;
    return terrain;
  }();
  return k_description;
}

template <>
std::vector<KeyRow> keys_of<firmware::terrain::Kind>() {
  return listed_keys<TerrainShape>();
}

}  // namespace maquette::sim
