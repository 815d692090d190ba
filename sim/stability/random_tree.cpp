#include "sim/stability/random_tree.hpp"

#include <iterator>
#include <utility>

#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

Object combined(firmware::BooleanOperator combination, std::vector<Object> children) {
  Object object;
  object.combination = combination;
  object.children = std::move(children);
  return object;
}

Object random_tree(trial::Random& random, const std::vector<SolidFamily>& families, int solids,
                   const Vector3& center, double spread) {
  constexpr double k_axis_ratio = 4;
  constexpr firmware::BooleanOperator k_operators[] = {firmware::BooleanOperator::union_of,
                                                       firmware::BooleanOperator::intersection,
                                                       firmware::BooleanOperator::difference};
  std::vector<Object> objects;
  for (int i = 0; i < solids; ++i) {
    const auto family = static_cast<std::size_t>(random.below(static_cast<int>(families.size())));
    const Vector3 place = center + random.in_cube(spread / 2);
    const double size = spread * random.uniform(0.2, 0.7);
    objects.push_back(
        random_solid(random, families[family], random.placement(place, size, k_axis_ratio)));
    objects.back().surface = k_trial_surfaces[random.below(std::size(k_trial_surfaces))];
  }
  while (objects.size() > 1) {
    const int first = random.below(static_cast<int>(objects.size()) - 1);
    const auto a = objects.begin() + first;
    *a = combined(k_operators[random.below(std::size(k_operators))],
                  {std::move(a[0]), std::move(a[1])});
    objects.erase(a + 1);
  }
  return objects.front();
}

}  // namespace maquette::sim
