#include "sim/accuracy/pareto_front.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace maquette::sim {

// In the order of the costs a point is on the front when its error is below all before it.
std::vector<bool> pareto_front(const std::vector<Tradeoff>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&points](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : points[a].error < points[b].error;
  });
  std::vector<bool> is_on_front(points.size());
  const Tradeoff* last = nullptr;
  for (const std::size_t index : order) {
    const Tradeoff& point = points[index];
    const bool equals_last =
        last != nullptr && point.cost == last->cost && point.error == last->error;
    if (last == nullptr || point.error < last->error || equals_last) {
      is_on_front[index] = true;
      last = &point;
    }
  }
  return is_on_front;
}

}  // namespace maquette::sim
