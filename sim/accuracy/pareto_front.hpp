#pragma once

#include <vector>

namespace maquette::sim {

/// What a level costs, and what it misses.
struct Tradeoff {
  double cost = 0;
  double error = 0;
};

/// For each point whether it is on the Pareto front: no other point is better in one of the two and
/// at least as good in the other. Equal points are on it together.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<Tradeoff>& points);

}  // namespace maquette::sim
