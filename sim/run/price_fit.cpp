#include "sim/run/price_fit.hpp"

#include <algorithm>
#include <cmath>

namespace maquette::sim {

namespace {

constexpr std::size_t k_classes = firmware::k_operation_count;
using Row = std::array<double, k_classes>;

/// Half the gradient of the sum of squares is matrix * prices - vector.
struct NormalEquations {
  std::array<Row, k_classes> matrix{};
  Row vector{};
};

NormalEquations normal_equations(const std::vector<PricedWork>& samples) {
  NormalEquations equations;
  for (const PricedWork& sample : samples) {
    for (std::size_t i = 0; i < k_classes; ++i) {
      const double count = sample.work.counts[i];
      equations.vector[i] += count * sample.milliclocks;
      for (std::size_t j = 0; j < k_classes; ++j) {
        equations.matrix[i][j] += count * sample.work.counts[j];
      }
    }
  }
  return equations;
}

/// Adds what holds prices to where they start: small against what any sample tells.
void hold_to(const Prices& start, NormalEquations& equations) {
  constexpr double k_weight = 1e-6;
  for (std::size_t i = 0; i < k_classes; ++i) {
    const double weight = k_weight * equations.matrix[i][i];
    equations.matrix[i][i] += weight;
    equations.vector[i] += weight * start[i];
  }
}

/// One price after the other to where the sum of squares is least; returns the largest change, as a
/// part of the price.
double descend(const NormalEquations& equations, Prices& prices) {
  double largest = 0;
  for (std::size_t i = 0; i < k_classes; ++i) {
    const Row& row = equations.matrix[i];
    if (row[i] == 0) {
      continue;
    }
    double rest = equations.vector[i];
    for (std::size_t j = 0; j < k_classes; ++j) {
      rest -= row[j] * prices[j];
    }
    const double price = std::max(0.0, prices[i] + rest / row[i]);
    largest = std::max(largest, std::abs(price - prices[i]) / (1 + prices[i]));
    prices[i] = price;
  }
  return largest;
}

}  // namespace

Prices fitted_prices(const std::vector<PricedWork>& samples, const Prices& start) {
  constexpr int k_most_rounds = 20'000;
  constexpr double k_least_change = 1e-9;
  NormalEquations equations = normal_equations(samples);
  hold_to(start, equations);
  Prices prices = start;
  for (int round = 0; round < k_most_rounds && descend(equations, prices) > k_least_change;
       ++round) {
  }
  return prices;
}

double cost(const firmware::Work& work, const Prices& prices) {
  double sum = 0;
  for (std::size_t i = 0; i < k_classes; ++i) {
    sum += prices[i] * work.counts[i];
  }
  return sum;
}

}  // namespace maquette::sim
