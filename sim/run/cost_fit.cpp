#include "sim/run/cost_fit.hpp"

#include <algorithm>
#include <cmath>

namespace maquette::sim {

namespace {

constexpr std::size_t k_classes = firmware::k_operation_count;
constexpr double k_bus_cycle_clocks = 4;  // MC68000 User's Manual, section 5
using Row = std::array<double, k_classes>;

/// Clocks in which nothing is read or written.
double internal_clocks(const models::OperationCost& cost) {
  return cost.clocks - k_bus_cycle_clocks * (cost.reads + cost.writes);
}
double reads(const models::OperationCost& cost) { return cost.reads; }
double writes(const models::OperationCost& cost) { return cost.writes; }

/// One of the three quantities that a cost consists of.
using Quantity = double (*)(const models::OperationCost&);

/// Half the gradient of the sum of squares is matrix * values - vector.
struct NormalEquations {
  std::array<Row, k_classes> matrix{};
  Row vector{};
};

NormalEquations normal_equations(const std::vector<CostSample>& samples, Quantity quantity) {
  NormalEquations equations;
  for (const CostSample& sample : samples) {
    const double taken = quantity(sample.taken);
    for (std::size_t i = 0; i < k_classes; ++i) {
      const double count = sample.weight * sample.work.counts[i];
      equations.vector[i] += count * taken;
      for (std::size_t j = 0; j < k_classes; ++j) {
        equations.matrix[i][j] += count * sample.work.counts[j];
      }
    }
  }
  return equations;
}

/// Adds what holds values to where they start: small against what any sample tells.
void hold_to(const Row& start, NormalEquations& equations) {
  constexpr double k_weight = 1e-6;
  for (std::size_t i = 0; i < k_classes; ++i) {
    const double weight = k_weight * equations.matrix[i][i];
    equations.matrix[i][i] += weight;
    equations.vector[i] += weight * start[i];
  }
}

/// One value after the other to where the sum of squares is least; returns the largest change, as a
/// part of the value.
double descend(const NormalEquations& equations, const Row& least, Row& values) {
  double largest = 0;
  for (std::size_t i = 0; i < k_classes; ++i) {
    const Row& row = equations.matrix[i];
    if (row[i] == 0) {
      continue;
    }
    double rest = equations.vector[i];
    for (std::size_t j = 0; j < k_classes; ++j) {
      rest -= row[j] * values[j];
    }
    const double value = std::max(least[i], values[i] + rest / row[i]);
    largest = std::max(largest, std::abs(value - values[i]) / (1 + values[i]));
    values[i] = value;
  }
  return largest;
}

Row row_of(const OperationCosts& costs, Quantity quantity) {
  Row row{};
  std::transform(costs.begin(), costs.end(), row.begin(), quantity);
  return row;
}

Row fitted(const std::vector<CostSample>& samples, const OperationCosts& start,
           const OperationCosts& least, Quantity quantity) {
  constexpr int k_most_rounds = 20'000;
  constexpr double k_least_change = 1e-9;
  NormalEquations equations = normal_equations(samples, quantity);
  const Row lowest = row_of(least, quantity);
  Row values = row_of(start, quantity);
  hold_to(values, equations);
  for (int round = 0; round < k_most_rounds && descend(equations, lowest, values) > k_least_change;
       ++round) {
  }
  return values;
}

}  // namespace

OperationCosts fitted_costs(const std::vector<CostSample>& samples, const OperationCosts& start,
                            const OperationCosts& least) {
  const Row internal = fitted(samples, start, least, internal_clocks);
  const Row read = fitted(samples, start, least, reads);
  const Row written = fitted(samples, start, least, writes);
  OperationCosts costs{};
  for (std::size_t i = 0; i < k_classes; ++i) {
    costs[i] = {internal[i] + k_bus_cycle_clocks * (read[i] + written[i]), read[i], written[i]};
  }
  return costs;
}

models::OperationCost cost_of(const firmware::Work& work, const OperationCosts& costs) {
  models::OperationCost sum;
  for (std::size_t i = 0; i < k_classes; ++i) {
    sum.clocks += costs[i].clocks * work.counts[i];
    sum.reads += costs[i].reads * work.counts[i];
    sum.writes += costs[i].writes * work.counts[i];
  }
  return sum;
}

}  // namespace maquette::sim
