#pragma once

#include <vector>

#include "firmware/database.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A primitive of the scene with all placements above it concatenated.
struct TreeLeaf {
  firmware::NodeIndex parent = firmware::k_no_node;
  firmware::PrimitiveKind kind{};
  std::size_t surface = 0;  ///< into Scene::surfaces
  std::vector<double> parameters;
  std::vector<double> given;  ///< what boards convert to them; else empty
  Placement to_scene{1.0};
  Placement own_frame{1.0};  ///< of the primitive, in which its shape is described, to the scene
  Placement surface_frame{1.0};  ///< of the object that names its surface, to the scene
};

/// The object tree of a scene as the firmware wants it: binary, leaves first, children before
/// parents.
struct ObjectTree {
  std::vector<TreeLeaf> leaves;
  std::vector<firmware::Composite> composites;
  firmware::NodeIndex root = 0;
  int height = 0;  ///< composites on the longest way down
};

/// Flattens the description's tree. Unions of many are halved where their children lie apart, so
/// that extents part early; A - B - C becomes A - (B u C); intersections chain in their order.
ObjectTree object_tree_of(const Scene& scene);

}  // namespace maquette::sim
