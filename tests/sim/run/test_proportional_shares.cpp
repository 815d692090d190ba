#include "sim/run/proportional_shares.hpp"

#include <numeric>
#include <random>

#include "tests/catch.hpp"

namespace {

using maquette::models::Duration;
using maquette::models::Wide;
using maquette::sim::proportional_shares;

Duration sum_of(const std::vector<Duration>& shares) {
  return std::accumulate(shares.begin(), shares.end(), Duration::zero());
}

}  // namespace

TEST_CASE("shares sum to the time exactly, each within a tick of its proportion") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const Duration total(static_cast<std::int64_t>(random() >> (1 + random() % 63)));
    std::vector<Wide> weights(1 + random() % 20);
    Wide sum = 0;
    for (Wide& weight : weights) {
      weight = random() >> (8 + random() % 56);
      sum += weight;
    }
    weights[0] += sum == 0 ? 1 : 0;
    sum += sum == 0 ? 1 : 0;
    const std::vector<Duration> shares = proportional_shares(total, weights);
    REQUIRE(sum_of(shares) == total);
    for (std::size_t share = 0; share < shares.size(); ++share) {
      const Wide exact = weights[share] * total.count();
      const Wide told = Wide{shares[share].count()} * sum;
      REQUIRE((told > exact - sum && told < exact + sum));
    }
  }
}

TEST_CASE("weights of more than 64 bits have shares that sum as well") {
  const std::vector<Wide> weights(300, Wide{1} << 90U);
  const std::vector<Duration> shares = proportional_shares(Duration::max(), weights);
  CHECK(sum_of(shares) == Duration::max());
  CHECK(shares.front() - shares.back() <= Duration(1));
}

TEST_CASE("ticks that are left go to the largest remainders, and of equal ones to the first") {
  CHECK(proportional_shares(Duration(10), {1, 1, 1}) ==
        std::vector<Duration>{Duration(4), Duration(3), Duration(3)});
  CHECK(proportional_shares(Duration(10), {1, 0, 5, 5}) ==
        std::vector<Duration>{Duration(1), Duration(0), Duration(5), Duration(4)});
  CHECK(proportional_shares(Duration(3), {0, 0}) == std::vector<Duration>(2));
}
