#include "sim/primitives/terrain_fields.hpp"

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

[[noreturn]] void fail(const YamlNode& node, std::string_view key, const std::string& message) {
  throw DescriptionError(nearest_node(node, key).place.position(),
                         std::string{key} + ": " + message);
}

}  // namespace

firmware::terrain::Shape<double> relief_of(const TerrainShape& shape) {
  const glm::dvec2& low = shape.corners[0];
  const glm::dvec2& high = shape.corners[1];
  return {shape.levels,       shape.seed,     -shape.depth, {low.x, low.y, high.x, high.y},
          shape.displacement, shape.roughness};
}

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

}  // namespace maquette::sim
