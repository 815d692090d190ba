#include <cmath>
#include <random>
#include <stdexcept>

#include "models/bus/access_law.hpp"
#include "models/bus/period.hpp"
#include "tests/catch.hpp"

namespace {

using namespace maquette::models;

TEST_CASE("a period does not drift and finds its own instants") {
  const Period pixel = Period::of_frequency(14.75e6);
  CHECK(pixel.times(59) == Duration{4'000'000});  // 59 clocks of 14.75 MHz last 4 us exactly
  CHECK(pixel.times(59'000'000'000) == Duration{4'000'000'000'000'000});
  std::mt19937_64 generator(3);
  for (const double hertz : {8e6, 14.75e6, 14.318181e6, 16.666667e6, 3.0}) {
    const Period period = Period::of_frequency(hertz);
    for (int one = 0; one < 2000; ++one) {
      const auto n = static_cast<std::int64_t>(generator() % 1'000'000);
      const Duration start = period.times(n);
      REQUIRE(period.index_at(start) == n);
      if (n > 0) {
        REQUIRE(period.index_at(start - k_tick) == n - 1);
      }
      REQUIRE(period.count_to_cover(start) == (start == Duration::zero() ? 0 : n));
      REQUIRE(period.count_to_cover(period.times(n) + k_tick) == n + 1);
      const auto exact = static_cast<long double>(n) * 1e12L / static_cast<long double>(hertz);
      REQUIRE(std::fabs(static_cast<long double>(start.count()) - exact) < 1.001L);
    }
  }
}

TEST_CASE("what is no frequency is refused") {
  for (const double hertz : {0.0, -8e6, 2e12, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(Period::of_frequency(hertz), std::invalid_argument);
  }
  CHECK_THROWS_AS(Period(0, 1), std::invalid_argument);
  CHECK_THROWS_AS(Period(1, -1), std::invalid_argument);
}

TEST_CASE("times that are longer than any are the longest") {
  CHECK(Period(1'000'000'000, 1).times(9'223'372'036) == Duration{9'223'372'036'000'000'000});
  CHECK(Period(1'000'000'000, 1).times(9'223'372'037) == Duration::max());
  CHECK(Period(1'000'000'000'000, 7).times(1'000'000'000'000) == Duration::max());
  CHECK(Period(9'000'000'000'000'000'000, 7).times(7) == Duration{9'000'000'000'000'000'000});
  CHECK_THROWS_AS(Period(1'000'000'000'000'000, 3).multiplied(65'535), std::invalid_argument);
  CHECK(Period(1'000'000'000'000'000, 3).multiplied(3).times(1) == Duration{1'000'000'000'000'000});
}

TEST_CASE("off-board access times of the KVM02: all rows of the data sheet, both ends") {
  const AccessLaw law{Period::of_frequency(8e6), 5, Duration{70'000}};
  struct Row {
    int from_ns;
    int to_ns;
    int total_ns;
  };
  const Row rows[] = {{0, 70, 625},     {71, 195, 750},   {196, 320, 875},  {321, 445, 1000},
                      {446, 570, 1125}, {571, 695, 1250}, {696, 820, 1375}, {821, 945, 1500}};
  for (const Row& row : rows) {
    CHECK(law.duration(Duration{row.from_ns * 1000}) == Duration{row.total_ns * 1000});
    CHECK(law.duration(Duration{row.to_ns * 1000}) == Duration{row.total_ns * 1000});
    CHECK(law.duration(Duration{row.to_ns * 1000 + 1}) == Duration{row.total_ns * 1000 + 125'000});
  }
}

TEST_CASE("no access ends before its acknowledge, nor later than its clocks have it") {
  std::mt19937_64 generator(71);
  const auto below = [&generator](int n) {
    return static_cast<std::int64_t>(generator() % static_cast<unsigned>(n));
  };
  int clamped = 0;
  for (int one = 0; one < 20'000; ++one) {
    const double hertz = std::exp2(20 + static_cast<double>(below(1'900)) / 100);
    const AccessLaw law{Period::of_frequency(hertz), 1 + below(8), Duration{below(200'000)}};
    const Duration slave_time{below(2'000'000)};
    const Duration duration = law.duration(slave_time);
    const Clocks clocks = law.clock.index_at(duration);
    REQUIRE(law.clock.times(clocks) == duration);
    REQUIRE(duration >= slave_time);
    REQUIRE(law.duration(slave_time + k_tick) >= duration);
    const Clocks by_slack =
        law.access_clocks + law.clock.count_to_cover(slave_time - law.access_slack);
    if (clocks != by_slack) {
      REQUIRE(law.clock.times(by_slack) < slave_time);
      REQUIRE(law.clock.times(clocks - 1) < slave_time);
      ++clamped;
    }
    REQUIRE((law.access_slack > law.clock.times(law.access_clocks) || clocks == by_slack));
  }
  CHECK(clamped > 1'000);
}

}  // namespace
