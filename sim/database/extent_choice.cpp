#include "sim/database/extent_choice.hpp"

namespace maquette::sim {

std::vector<std::uint32_t> leaves_below(const ObjectTree& tree) {
  std::vector<std::uint32_t> counts(tree.leaves.size(), 1);
  for (const firmware::Composite& composite : tree.composites) {
    counts.push_back(counts[composite.children[0]] + counts[composite.children[1]]);
  }
  return counts;
}

}  // namespace maquette::sim
