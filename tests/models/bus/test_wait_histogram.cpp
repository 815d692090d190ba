#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "models/bus/wait_histogram.hpp"
#include "tests/catch.hpp"

namespace {

using maquette::models::Duration;
using maquette::models::WaitHistogram;

constexpr std::int64_t k_inverse_resolution = 16;

// Waits of every magnitude, and some that occur again and again.
Duration random_wait(std::mt19937_64& random) {
  const auto bits = random() % 62;
  return Duration(random() % 4 == 0 ? 500'000
                                    : static_cast<std::int64_t>(random() >> (63U - bits)));
}

Duration exact_quantile(std::vector<Duration> waits, int per_mille) {
  std::sort(waits.begin(), waits.end());
  std::size_t rank = 1;
  while (rank * 1000 < waits.size() * static_cast<std::size_t>(per_mille)) {
    ++rank;
  }
  return waits[rank - 1];
}

TEST_CASE("buckets tile the waits and count each one once, at the stated resolution") {
  std::mt19937_64 random(71);
  for (int round = 0; round < 50; ++round) {
    WaitHistogram histogram;
    std::vector<Duration> waits(1 + random() % 300);
    for (Duration& wait : waits) {
      wait = random_wait(random);
      histogram.add(wait);
    }
    REQUIRE(histogram.count() == static_cast<std::int64_t>(waits.size()));
    std::int64_t counted = 0;
    Duration edge{0};
    for (const auto& [from, to, count] : histogram.buckets()) {
      REQUIRE(from >= edge);
      REQUIRE(to > from);
      REQUIRE(((to - from).count() == 1 || (to - from) * k_inverse_resolution <= from));
      REQUIRE(count ==
              std::count_if(waits.begin(), waits.end(),
                            [from = from, to = to](Duration w) { return w >= from && w < to; }));
      counted += count;
      edge = to;
    }
    REQUIRE(counted == histogram.count());
  }
}

TEST_CASE("a quantile is a wait that occurred, at most a sixteenth above the exact one") {
  std::mt19937_64 random(72);
  for (int round = 0; round < 200; ++round) {
    WaitHistogram histogram;
    std::vector<Duration> waits(1 + random() % 2000);
    for (Duration& wait : waits) {
      wait = random_wait(random);
      histogram.add(wait);
    }
    for (const int per_mille : {1, 500, 900, 990, 999, 1000}) {
      const Duration exact = exact_quantile(waits, per_mille);
      const Duration given = histogram.quantile(per_mille);
      INFO(per_mille << " of " << waits.size() << ": " << exact.count() << " " << given.count());
      REQUIRE(given >= exact);
      REQUIRE((given - exact) * k_inverse_resolution <= exact);
      REQUIRE(std::find(waits.begin(), waits.end(), given) != waits.end());
    }
    REQUIRE(histogram.quantile(1000) == *std::max_element(waits.begin(), waits.end()));
  }
}

TEST_CASE("histograms add up to that of all their waits") {
  std::mt19937_64 random(73);
  WaitHistogram all;
  WaitHistogram sum;
  for (int part = 0; part < 8; ++part) {
    WaitHistogram one;
    for (int i = 0; i < 100; ++i) {
      const Duration wait = random_wait(random);
      one.add(wait);
      all.add(wait);
    }
    sum.add(one);
  }
  CHECK(sum.count() == 800);
  for (int per_mille = 0; per_mille <= 1000; ++per_mille) {
    REQUIRE(sum.quantile(per_mille) == all.quantile(per_mille));
  }
  CHECK(sum.buckets().size() == all.buckets().size());
}

TEST_CASE("the shortest and the longest waits have buckets") {
  WaitHistogram histogram;
  CHECK(histogram.quantile(500) == Duration::zero());
  CHECK(histogram.buckets().empty());
  for (const std::int64_t ticks : {std::int64_t{0}, std::numeric_limits<std::int64_t>::max() / 4}) {
    histogram.add(Duration(ticks));
    CHECK(histogram.quantile(1000) == Duration(ticks));
    const auto last = histogram.buckets().back();
    CHECK(last.from.count() <= ticks);
    CHECK(last.to.count() > ticks);
  }
}

}  // namespace
