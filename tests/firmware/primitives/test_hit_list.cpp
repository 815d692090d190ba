#include "firmware/primitives/hit_list.hpp"

#include <algorithm>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using trial::Random;

/// Takes hits as they are found, of which a few come at a time.
std::vector<double> taken(const std::vector<double>& found) {
  constexpr int k_at_once = 6;
  Hit<double> hits[k_primitive_hit_limit];
  HitList<double> list = hit_list(hits);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i % k_at_once == 0) {
      make_room(list, k_at_once);
    }
    REQUIRE(list.count < k_primitive_hit_limit);
    hits[list.count++] = {found[i], 0};
  }
  const int count = in_order(list);
  REQUIRE(count % 2 == 0);
  std::vector<double> distances;
  for (int i = 0; i < count; ++i) {
    distances.push_back(hits[i].distance);
  }
  return distances;
}

std::vector<double> random_hits(Random& random, int count, double low) {
  std::vector<double> found;
  for (int i = 0; i < count; ++i) {
    found.push_back(random.uniform(low, 1));
  }
  return found;
}

std::vector<double> sorted(std::vector<double> hits) {
  std::sort(hits.begin(), hits.end());
  return hits;
}

TEST_CASE("Hits for which there is room all stay, in order") {
  Random random(2001);
  for (int count = 0; count <= k_primitive_hit_limit - 6; count += 2) {
    const std::vector<double> found = random_hits(random, count, -1);
    CHECK(taken(found) == sorted(found));
  }
}

TEST_CASE("Of more hits the nearest ahead stay, and whether the ray starts inside") {
  Random random(2002);
  for (int i = 0; i < 200; ++i) {
    const int count = 2 * (130 + random.below(500));
    std::vector<double> found = random_hits(random, count, random.coin() ? -1 : -0.1);
    if (random.coin()) {
      // First the near ones, then the far ones, then a few between.
      std::sort(found.begin(), found.end());
      std::rotate(found.begin() + count / 3, found.begin() + count / 3 + 60, found.end());
    }
    const std::vector<double> all = sorted(found);
    const std::vector<double> left = taken(found);
    const auto behind = std::count_if(all.begin(), all.end(), [](double d) { return d < 0; });
    const auto left_behind =
        std::count_if(left.begin(), left.end(), [](double d) { return d < 0; });
    CAPTURE(count, behind, left_behind);
    REQUIRE(left_behind % 2 == behind % 2);
    const auto ahead = static_cast<std::ptrdiff_t>(left.size()) - left_behind;
    REQUIRE(ahead >= std::min<std::ptrdiff_t>(100, count - behind));
    REQUIRE(std::equal(left.begin() + left_behind, left.end(), all.begin() + behind));
    if (left_behind > 0) {
      REQUIRE(left[static_cast<std::size_t>(left_behind - 1)] ==
              all[static_cast<std::size_t>(behind - 1)]);
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
