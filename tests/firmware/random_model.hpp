#pragma once

#include "tests/firmware/convex_solids.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware::trial {

/// A model of primitives near a center, combined at random.
struct RandomTree {
  Model model;
  NodeIndex root;
};

/// Of `solid_count` convex primitives around `center`, within about `spread` of it. Surfaces
/// are taken from the model given.
inline RandomTree random_tree(Random& random, Model model, int solid_count,
                              const Vector<double>& center, double spread) {
  std::vector<NodeIndex> nodes;
  for (int i = 0; i < solid_count; ++i) {
    const PrimitiveKind kind = k_convex_solids[random.below(k_convex_solid_count)].kind;
    const auto surface =
        static_cast<SurfaceIndex>(random.below(static_cast<int>(model.surfaces.size())));
    const Vector<double> place = center + random.in_cube(spread / 2);
    const double top = random.coin() ? 0 : random.uniform(0.1, 0.9);
    nodes.push_back(model.add(kind, random.placement(place, spread * random.uniform(0.2, 0.7), 4),
                              surface, top));
  }
  while (nodes.size() > 1) {
    const auto a = static_cast<std::size_t>(random.below(static_cast<int>(nodes.size()) - 1));
    const auto combination = static_cast<BooleanOperator>(random.below(3));
    nodes[a] = model.combine(combination, nodes[a], nodes[a + 1]);
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(a) + 1);
  }
  return {std::move(model), nodes.front()};
}

}  // namespace maquette::firmware::trial
