#include <fmt/format.h>

#include <algorithm>

#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

namespace {

/// A ray of this weight or less cannot move a level of the picture, unless it meets a luminance of
/// 256 times full scale. It also bounds the rays of a tree of any depth.
constexpr double k_negligible_weight = 1.0 / 65536;

constexpr int k_limiting_depth = 64;

/// Work areas for any of these trees, whatever else a board's RAM holds: times do not depend on
/// them.
std::vector<std::string> roomy_boards() {
  return {fmt::format("board.waiting_rays={}", k_limiting_depth + 1), "board.allow_overflow=true"};
}

Level level_of(const std::string& name, const RayTree& tree) {
  std::vector<std::string> overrides = roomy_boards();
  overrides.push_back(fmt::format("ray_tree.depth={}", tree.depth));
  overrides.push_back(fmt::format("ray_tree.minimum_weight={}", tree.minimum_weight));
  return {name, overrides};
}

template <class Value>
void include(std::vector<Value>& sorted, Value value) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (place == sorted.end() || *place != value) {
    sorted.insert(place, value);
  }
}

}  // namespace

Ladder depth_ladder(const RayTree& scene) {
  Ladder ladder{"depth", "secondary rays in a row (ray_tree.depth)", ErrorMeasure::picture, {}, 0};
  const double weight = std::max(scene.minimum_weight, k_negligible_weight);
  std::vector<int> depths = {0, 1, 2, 3, 4, 6, 8};
  include(depths, std::min(scene.depth, k_limiting_depth));
  include(depths, k_limiting_depth);
  std::reverse(depths.begin(), depths.end());
  for (const int depth : depths) {
    ladder.levels.push_back(level_of(fmt::format("depth {}", depth), {depth, weight}));
  }
  return ladder;
}

Ladder weight_ladder(const RayTree& scene) {
  Ladder ladder{"weight",
                "weight below which no ray is cast (ray_tree.minimum_weight)",
                ErrorMeasure::picture,
                {},
                0};
  const int depth = std::min(scene.depth, k_limiting_depth);
  std::vector<double> weights = {0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5};
  include(weights, std::max(scene.minimum_weight, k_negligible_weight));
  include(weights, k_negligible_weight);
  for (const double weight : weights) {
    ladder.levels.push_back(level_of(fmt::format("weight {:.3g}", weight), {depth, weight}));
  }
  return ladder;
}

}  // namespace maquette::sim
