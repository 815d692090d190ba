#include "sim/primitives/patch_order.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace maquette::sim {
namespace {

using Numbers = std::vector<std::size_t>;

Extent3 extent_of_some(const std::vector<PatchNet>& nets, Numbers::iterator first,
                       Numbers::iterator end) {
  std::vector<PatchNet> some;
  std::transform(first, end, std::back_inserter(some),
                 [&nets](std::size_t number) { return nets[number]; });
  return extent_of(some);
}

int longest_edge(const Extent3& extent) {
  const glm::dvec3 edges = extent.high - extent.low;
  return edges.x > edges.y ? (edges.x > edges.z ? 0 : 2) : (edges.y > edges.z ? 1 : 2);
}

void halve(const std::vector<PatchNet>& nets, Numbers::iterator first, Numbers::iterator end) {
  if (end - first < 2) {
    return;
  }
  const int axis = longest_edge(extent_of_some(nets, first, end));
  const auto middle = [&nets, axis](std::size_t number) {
    const Extent3 extent = extent_of({nets[number]});
    return extent.low[axis] + extent.high[axis];
  };
  std::stable_sort(first, end,
                   [&middle](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
  const auto half = first + (end - first) / 2;
  halve(nets, first, half);
  halve(nets, half, end);
}

}  // namespace

std::vector<std::size_t> patch_order(const std::vector<PatchNet>& nets) {
  Numbers numbers(nets.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  halve(nets, numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace maquette::sim
