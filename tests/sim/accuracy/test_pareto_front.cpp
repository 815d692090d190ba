#include <algorithm>
#include <random>

#include "sim/accuracy/pareto_front.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

bool beats(const Tradeoff& a, const Tradeoff& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}  // namespace

TEST_CASE("the front is what nobody beats, by brute force") {
  std::mt19937 random(1896);
  for (int round = 0; round < 2000; ++round) {
    std::vector<Tradeoff> points(random() % 12);
    const unsigned places = 1 + random() % 8;  // few, so that many coincide in one or both
    for (Tradeoff& point : points) {
      point = {static_cast<double>(random() % places), static_cast<double>(random() % places)};
    }
    const std::vector<bool> front = pareto_front(points);
    REQUIRE(front.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_beaten = std::any_of(points.begin(), points.end(), [&](const Tradeoff& other) {
        return beats(other, points[i]);
      });
      REQUIRE(front[i] == !is_beaten);
    }
  }
}
