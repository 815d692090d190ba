#include "firmware/polynomials/strip_tree.hpp"

#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::strip_tree {
namespace {

struct Kept {
  std::vector<Strip<double>> strips;
  std::vector<int> levels;
  void operator()(const Strip<double>& strip, int level) {
    strips.push_back(strip);
    levels.push_back(level);
  }
};

std::vector<double> random_chain(trial::Random& random, int sections) {
  std::vector<double> points;
  for (int i = 0; i <= 3 * sections; ++i) {
    points.push_back(random.uniform(0, 1) + 0.2 * i);
    points.push_back(random.uniform(-1, 1));
  }
  return points;
}

bool holds(const Strip<double>& strip, double x, double y) {
  constexpr double k_rounding = 1e-12;
  const double dx = x - strip.begin[0];
  const double dy = y - strip.begin[1];
  const double along = dx * strip.direction[0] + dy * strip.direction[1];
  const double across = dy * strip.direction[0] - dx * strip.direction[1];
  return along >= strip.low_along - k_rounding && along <= strip.high_along + k_rounding &&
         across >= strip.low_across - k_rounding && across <= strip.high_across + k_rounding;
}

TEST_CASE("The root holds the whole curve, and some leaf each point of it") {
  trial::Random random(1901);
  for (int trial = 0; trial < 40; ++trial) {
    const int sections = 1 + random.below(6);
    const std::vector<double> points = random_chain(random, sections);
    const double tolerance = random.magnitude(1e-4, 1e-1);
    Kept kept;
    build(points.data(), sections, tolerance, kept);
    for (int i = 0; i <= 50 * sections; ++i) {
      const int section = i == 50 * sections ? sections - 1 : i / 50;
      const double* const from = points.data() + section * k_section_stride;
      const double u = (i - 50 * section) / 50.0;
      const double x = value_at(coordinate(from), u);
      const double y = value_at(coordinate(from + 1), u);
      REQUIRE(holds(kept.strips.front(), x, y));
      bool is_held = false;
      for (const Strip<double>& strip : kept.strips) {
        is_held =
            is_held || (strip.high_across - strip.low_across <= tolerance && holds(strip, x, y));
      }
      REQUIRE(is_held);
    }
  }
}

TEST_CASE(
    "A sixteenth of the tolerance takes about two more levels, a straight section one strip") {
  trial::Random random(1902);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<double> points = random_chain(random, 1);
    Kept coarse;
    Kept fine;
    const int first = build(points.data(), 1, 1e-3, coarse);
    const int second = build(points.data(), 1, 1e-3 / 16, fine);
    REQUIRE(second >= first + 1);
    REQUIRE(second <= first + 3);
    REQUIRE(fine.strips.size() % 2 == 1);
    REQUIRE(fine.strips.size() > coarse.strips.size());
  }
  const double line[] = {1, 0, 1, 1, 1, 2, 1, 3};
  Kept one;
  CHECK(build(line, 1, 1e-6, one) == 0);
  CHECK(one.strips.size() == 1);
  const double still[] = {1, 0, 1, 0, 1, 0, 1, 0};
  CHECK(build(still, 1, 1e-6, one) == 0);
}

TEST_CASE("Making a strip of a section takes a square root and a division") {
  reset_counted_work();
  const Counted line[] = {1.0F, 0.0F, 1.0F, 1.0F, 1.0F, 2.0F, 1.0F, 3.0F};
  const auto forget = [](const Strip<Counted>& /*strip*/, int /*level*/) {};
  build(line, 1, Counted(1e-6F), forget);
  const Work work = counted_work();
  CHECK(work[Operation::square_root] == 1);
  CHECK(work[Operation::divide] + work[Operation::divide_zero] == 1);
}

}  // namespace
}  // namespace maquette::firmware::strip_tree
