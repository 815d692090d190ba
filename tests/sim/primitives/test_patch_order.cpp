#include "sim/primitives/patch_order.hpp"

#include <algorithm>
#include <set>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

PatchNet net_at(Random& random, const glm::dvec3& place) {
  PatchNet net;
  for (glm::dvec3& point : net) {
    point = place + random.in_cube(0.3);
  }
  return net;
}

}  // namespace

TEST_CASE("Every patch has one place in the order, those in a row that along the row") {
  Random random(6101);
  for (int i = 0; i < 50; ++i) {
    const int patches = 1 + random.below(40);
    const int axis = random.below(3);
    std::vector<int> places(static_cast<std::size_t>(patches));
    for (int k = 0; k < patches; ++k) {
      places[static_cast<std::size_t>(k)] = k;
    }
    std::vector<PatchNet> nets;
    for (int k = patches; k > 0; --k) {
      const auto taken = places.begin() + random.below(k);
      glm::dvec3 place(0, 0, 0);
      place[axis] = *taken;
      nets.push_back(net_at(random, place));
      places.erase(taken);
    }
    const std::vector<std::size_t> order = patch_order(nets);
    CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == nets.size());
    CHECK(std::is_sorted(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return nets[a][0][axis] + 0.31 < nets[b][0][axis] - 0.31;
    }));
  }
}

TEST_CASE("Patches far apart are in different halves") {
  Random random(6102);
  std::vector<PatchNet> nets;
  for (int i = 0; i < 8; ++i) {
    nets.push_back(net_at(random, {i % 2 == 0 ? 100 : -100, i, 0}));
  }
  const std::vector<std::size_t> order = patch_order(nets);
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(order[i] % 2 == (i < order.size() / 2 ? 1 : 0));
  }
}

}  // namespace maquette::sim
