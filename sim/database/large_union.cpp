#include "sim/database/large_union.hpp"

#include <vector>

#include "firmware/extent.hpp"
#include "firmware/preprocess.hpp"
#include "firmware/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

using Box = firmware::Box<double>;

/// Bodies that unions within unions put together, of those that have bounds.
struct United {
  std::size_t bodies = 0;
  Box box{};            ///< around them; of what is no union, around it
  double area_sum = 0;  ///< of their boxes' surfaces
};

double area_of(const Box& box) {
  const Vector3 size = box.high - box.low;
  return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

United body(const Box& box) { return {1, box, area_of(box)}; }

United united_leaf(const TreeLeaf& leaf) {
  Box local{};
  const bool is_bounded =
      firmware::primitive_of<double>(leaf.kind).bounds(leaf.parameters.data(), local);
  return is_bounded ? body(firmware::preprocessing::box_around(local, leaf.to_scene)) : United{};
}

United united_node(firmware::BooleanOperator combination, const United& a, const United& b) {
  if (combination == firmware::k_keeps_all && a.bodies > 0 && b.bodies > 0) {
    return {a.bodies + b.bodies,
            {glm::min(a.box.low, b.box.low), glm::max(a.box.high, b.box.high)},
            a.area_sum + b.area_sum};
  }
  const bool second_bounds =
      combination == firmware::k_keeps_all || combination == firmware::k_drops_first;
  const United& bounded = a.bodies == 0 && second_bounds ? b : a;
  return combination == firmware::k_keeps_all || bounded.bodies == 0 ? bounded : body(bounded.box);
}

/// The bodies whose boxes a line through the box of all meets on average: of convex ones in one
/// another it meets each as often as their surfaces are to one another (Cauchy).
double bodies_on_a_line(const United& all) {
  const double area = area_of(all.box);
  return area > 0 ? all.area_sum / area : 0;
}

bool takes_boxes(const United& all) {
  return all.bodies >= k_always_in_boxes ||
         (all.bodies >= k_fewest_in_boxes && bodies_on_a_line(all) >= k_bodies_on_a_line);
}

}  // namespace

bool takes_boxes(const ObjectTree& tree) {
  if (tree.leaves.size() < k_fewest_in_boxes) {
    return false;
  }
  std::vector<United> nodes;
  nodes.reserve(tree.leaves.size() + tree.composites.size());
  for (const TreeLeaf& leaf : tree.leaves) {
    nodes.push_back(united_leaf(leaf));
  }
  for (const firmware::Composite& composite : tree.composites) {
    nodes.push_back(united_node(composite.combination, nodes[composite.children[0]],
                                nodes[composite.children[1]]));
    if (takes_boxes(nodes.back())) {
      return true;
    }
  }
  return false;
}

}  // namespace maquette::sim
