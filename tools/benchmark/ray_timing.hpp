#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <random>
#include <vector>

#include "firmware/vector.hpp"

/// What rays against one primitive cost, in this process.
namespace maquette::benchmark {

inline constexpr int k_rays = 4096;
inline constexpr int k_repetitions = 21;

/// From points far off to points in the cube around the primitive.
template <class Real>
std::vector<firmware::Ray<Real>> ordinary_rays() {
  std::mt19937 engine(1984);
  const auto uniform = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1; };
  const auto point = [&](double size) {
    const double x = uniform() * size;
    const double y = uniform() * size;
    return firmware::Vector<Real>(firmware::Vector<double>(x, y, uniform() * size));
  };
  std::vector<firmware::Ray<Real>> rays;
  for (int i = 0; i < k_rays; ++i) {
    const firmware::Vector<Real> origin = point(5);
    rays.push_back({origin, point(1) - origin});
  }
  return rays;
}

/// Least processor time of one call, over all rays, in ns. What the calls return is summed and
/// looked at, so that none is left out.
template <class Call>
double least_ns(int calls_per_turn, Call call) {
  constexpr double k_ns_per_tick = 1e9 / CLOCKS_PER_SEC;
  double least = 1e18;
  std::int64_t hits = 0;
  for (int i = 0; i < k_repetitions; ++i) {
    const std::clock_t start = std::clock();
    hits += call();
    const auto ticks = static_cast<double>(std::clock() - start);
    least = std::min(least, ticks * k_ns_per_tick / calls_per_turn);
  }
  return hits > 0 ? least : 0;
}

}  // namespace maquette::benchmark
