#include "sim/sweep/latin_hypercube.hpp"

#include <cstddef>
#include <numeric>
#include <random>
#include <utility>

namespace maquette::sim {
namespace {

/// In [0, 1), from the upper 53 bits.
double share_of(std::mt19937_64& generator) {
  constexpr double k_unit = 1.0 / 9007199254740992.0;  // 2^-53
  return static_cast<double>(generator() >> 11) * k_unit;
}

/// The numbers from 0 to samples - 1 in a random order (Fisher and Yates).
std::vector<int> random_order(int samples, std::mt19937_64& generator) {
  std::vector<int> order(static_cast<std::size_t>(samples));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(share_of(generator) * static_cast<double>(i));
    std::swap(order[i - 1], order[other]);
  }
  return order;
}

}  // namespace

std::vector<std::vector<double>> latin_hypercube(int axes, int samples, std::uint64_t seed) {
  std::mt19937_64 generator{seed};
  std::vector<std::vector<double>> shares(static_cast<std::size_t>(axes));
  for (std::vector<double>& axis : shares) {
    for (const int part : random_order(samples, generator)) {
      axis.push_back((part + share_of(generator)) / samples);
    }
  }
  return shares;
}

}  // namespace maquette::sim
