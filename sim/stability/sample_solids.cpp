#include "sim/stability/sample_solids.hpp"

#include <algorithm>

#include "firmware/extent.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

namespace {

/// Brings the middle of a box to the origin and its longest half edge to 1.
Placement into_unit_cube(const firmware::Box<double>& box) {
  const Vector3 middle = (box.low + box.high) / 2.0;
  const double scale = 1 / firmware::magnitude(box.high - middle);
  return firmware::concatenate(trial::scaled({scale, scale, scale}), trial::moved(-middle));
}

void add_solid(Object solid, std::vector<SolidFamily>& families) {
  solid.name.clear();
  solid.placement = Placement(1.0);
  solid.surface = k_trial_surfaces[0];
  Scene scene;
  scene.surfaces.emplace_back().name = solid.surface;
  scene.object = solid;
  const TreeLeaf leaf = object_tree_of(scene).leaves.front();
  SolidFamily& family = families[static_cast<std::size_t>(leaf.kind)];
  firmware::Box<double> box{};
  family.kind = leaf.kind;
  family.is_bounded = firmware::primitive_of<double>(leaf.kind).bounds(leaf.parameters.data(), box);
  solid.placement = inverse_of(leaf.to_scene);
  if (family.is_bounded) {
    solid.placement = concatenated(into_unit_cube(box), solid.placement);
  }
  family.solids.push_back(std::move(solid));
}

bool is_solid(const Primitive& primitive) {
  return primitive.description->why_opaque(primitive.shape).empty();
}

void add_solids(const Object& object, std::vector<SolidFamily>& families) {
  if (object.primitive && is_solid(*object.primitive)) {
    add_solid(object, families);
  }
  for (const Object& child : object.children) {
    add_solids(child, families);
  }
}

}  // namespace

std::vector<SolidFamily> solid_families(const std::vector<ShippedScene>& scenes) {
  std::vector<SolidFamily> families(firmware::k_primitive_kind_count);
  for (const ShippedScene& shipped : scenes) {
    add_solids(shipped.scene.object, families);
  }
  families.erase(std::remove_if(families.begin(), families.end(),
                                [](const SolidFamily& family) { return family.solids.empty(); }),
                 families.end());
  for (SolidFamily& family : families) {
    family.name = description_of(family.kind).name;
  }
  return families;
}

Object random_solid(trial::Random& random, const SolidFamily& family, const Placement& placement) {
  Object solid =
      family.solids[static_cast<std::size_t>(random.below(static_cast<int>(family.solids.size())))];
  solid.placement = concatenated(placement, solid.placement);
  return solid;
}

}  // namespace maquette::sim
