#include "sim/database/needs.hpp"

#include <algorithm>

#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/database/large_union.hpp"
#include "sim/database/texture_packing.hpp"
#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

template <class Predicate>
bool any_surface(const std::vector<firmware::Surface<double>>& surfaces, Predicate predicate) {
  return std::any_of(surfaces.begin(), surfaces.end(), predicate);
}

/// Whether that is true of any surface that a primitive has.
template <class Predicate>
bool any_tree_surface(const Scene& scene, const ObjectTree& tree, Predicate predicate) {
  return std::any_of(tree.leaves.begin(), tree.leaves.end(),
                     [&](const TreeLeaf& leaf) { return predicate(scene.surfaces[leaf.surface]); });
}

bool combines_by(const ObjectTree& tree, firmware::BooleanOperator combination) {
  return std::any_of(
      tree.composites.begin(), tree.composites.end(),
      [combination](const firmware::Composite& c) { return c.combination == combination; });
}

}  // namespace

firmware::Needs needs_of(const Scene& scene, const ObjectTree& tree,
                         const std::vector<firmware::Surface<double>>& surfaces) {
  using Packed = firmware::Surface<double>;
  firmware::Needs needs{};
  for (const TreeLeaf& leaf : tree.leaves) {
    needs.primitives[static_cast<int>(leaf.kind)] = true;
    needs.several_spans =
        needs.several_spans || !firmware::primitive_of<double>(leaf.kind).is_convex;
  }
  needs.unions = combines_by(tree, firmware::BooleanOperator::union_of);
  needs.large_unions = takes_boxes(tree);
  needs.intersections = combines_by(tree, firmware::BooleanOperator::intersection);
  needs.differences = combines_by(tree, firmware::BooleanOperator::difference);
  needs.diffuse = any_surface(surfaces, [](const Packed& s) { return s.specular < 1; });
  needs.specular = any_surface(surfaces, [](const Packed& s) { return s.specular > 0; });
  needs.dielectrics = any_surface(
      surfaces, [](const Packed& s) { return s.transparent || (s.specular > 0 && !s.metal); });
  needs.metals = any_surface(surfaces, [](const Packed& s) { return s.specular > 0 && s.metal; });
  needs.transparency = any_surface(surfaces, [](const Packed& s) { return s.transparent; });
  needs.absorption = any_surface(surfaces, [](const Packed& s) { return s.absorbing; });
  needs.lights = !scene.lights.empty();
  needs.shadows = scene.shadows && needs.lights;
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    needs.facets[kind] = needs.lights && any_surface(surfaces, [kind](const Packed& s) {
                           return s.specular > 0 && static_cast<int>(s.facets) == kind;
                         });
  }
  needs.surface_ambient = needs.diffuse && any_tree_surface(scene, tree, [](const Surface& s) {
                            return s.ambient && *s.ambient != Color(0, 0, 0);
                          });
  needs.ambient = needs.surface_ambient || (needs.diffuse && scene.ambient != Color(0, 0, 0));
  needs.shaped_lights = std::any_of(scene.lights.begin(), scene.lights.end(),
                                    [](const Light& light) { return light.falloff || light.spot; });
  for (int kind = 0; kind < firmware::k_texture_kind_count; ++kind) {
    needs.textures[kind] = any_tree_surface(scene, tree, [kind](const Surface& s) {
      return s.texture && static_cast<int>(kind_of(*s.texture)) == kind;
    });
    needs.textured = needs.textured || needs.textures[kind];
  }
  needs.parallel_view = scene.view.projection == firmware::Projection::parallel;
  needs.samples = scene.samples && scene.samples->per_side > 1;
  needs.reflections = needs.specular && scene.ray_tree.depth > 0;
  return needs;
}

namespace {

/// Calls `visit(name, need)` for each need of `needs`; a parallel view is none, since what it has
/// stands in place of something else.
template <class Visit>
void for_each_need(firmware::Needs& needs, Visit visit) {
  for (std::size_t kind = 0; kind < primitive_table().size(); ++kind) {
    visit(std::string{primitive_table()[kind]->name}, needs.primitives[kind]);
  }
  visit("several spans", needs.several_spans);
  visit("union", needs.unions);
  visit("large union", needs.large_unions);
  visit("intersection", needs.intersections);
  visit("difference", needs.differences);
  visit("diffuse reflection", needs.diffuse);
  visit("specular reflection", needs.specular);
  visit("dielectrics", needs.dielectrics);
  visit("metals", needs.metals);
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    const firmware::FacetDistribution& facets = firmware::k_facet_distributions.rows[kind];
    visit(std::string{facets.title} + " facets", needs.facets[kind]);
  }
  visit("transparency", needs.transparency);
  visit("absorption", needs.absorption);
  visit("lights", needs.lights);
  visit("shadows", needs.shadows);
  visit("ambient light", needs.ambient);
  visit("secondary rays", needs.reflections);
  visit("depth of pixels", needs.depth);
  visit("ambient light of surfaces", needs.surface_ambient);
  visit("shaped lights", needs.shaped_lights);
  for (int kind = 0; kind < firmware::k_texture_kind_count; ++kind) {
    visit(std::string{firmware::k_textures.rows[kind].name} + " texture", needs.textures[kind]);
  }
  visit("textures", needs.textured);
  visit("several rays a pixel", needs.samples);
}

}  // namespace

std::vector<NamedNeed> named_needs(const firmware::Needs& needs) {
  std::vector<NamedNeed> named;
  firmware::Needs with = needs;
  for_each_need(with, [&](const std::string& name, bool& need) {
    const bool is_needed = need;
    need = true;
    named.push_back({name, is_needed, with});
    need = is_needed;
  });
  return named;
}

}  // namespace maquette::sim
