#include "sim/run/cost_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

using Matrix = std::array<Row, k_classes>;

/// Half the gradient of the sum of squares is matrix * values - vector.
struct NormalEquations {
  Matrix matrix{};
  Row vector{};
};

Matrix normal_matrix(const std::vector<CostSample>& samples) {
  Matrix matrix{};
  for (const CostSample& sample : samples) {
    for (std::size_t i = 0; i < k_classes; ++i) {
      const double count = sample.weight * sample.work.counts[i];
      if (count > 0) {
        for (std::size_t j = 0; j < k_classes; ++j) {
          matrix[i][j] += count * sample.work.counts[j];
        }
      }
    }
  }
  return matrix;
}

Row normal_vector(const std::vector<CostSample>& samples, Quantity quantity) {
  Row vector{};
  for (const CostSample& sample : samples) {
    const double taken = quantity(sample.taken);
    for (std::size_t i = 0; i < k_classes; ++i) {
      vector[i] += sample.weight * sample.work.counts[i] * taken;
    }
  }
  return vector;
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

/// What is above the least values, of the classes that are not held to them, where the gradient is
/// zero: the solution of the equations of these classes by elimination. They are positive definite.
Row solution(const NormalEquations& equations, const std::vector<std::size_t>& free) {
  std::vector<Row> rows;
  Row right{};
  for (const std::size_t i : free) {
    rows.push_back(equations.matrix[i]);
    right[i] = equations.vector[i];
  }
  for (std::size_t k = 0; k < free.size(); ++k) {
    for (std::size_t row = k + 1; row < free.size(); ++row) {
      const double factor = rows[row][free[k]] / rows[k][free[k]];
      for (std::size_t j = k; j < free.size(); ++j) {
        rows[row][free[j]] -= factor * rows[k][free[j]];
      }
      right[free[row]] -= factor * right[free[k]];
    }
  }
  Row values{};
  for (std::size_t k = free.size(); k-- > 0;) {
    double rest = right[free[k]];
    for (std::size_t j = k + 1; j < free.size(); ++j) {
      rest -= rows[k][free[j]] * values[free[j]];
    }
    values[free[k]] = rest / rows[k][free[k]];
  }
  return values;
}

/// The class that gains most by rising from its least value, by the gradient over the square root
/// of its diagonal; none when none gains more than rounding.
std::optional<std::size_t> most_gaining(const NormalEquations& equations, const Row& values,
                                        const std::vector<std::size_t>& free) {
  constexpr double k_least_gain = 1e-9;
  std::optional<std::size_t> best;
  double most = 0;
  for (std::size_t i = 0; i < k_classes; ++i) {
    const Row& row = equations.matrix[i];
    if (row[i] == 0 || std::find(free.begin(), free.end(), i) != free.end()) {
      continue;
    }
    double gradient = equations.vector[i];
    for (std::size_t j = 0; j < k_classes; ++j) {
      gradient -= row[j] * values[j];
    }
    const double gain = gradient / std::sqrt(row[i]);
    if (gradient > k_least_gain * std::abs(equations.vector[i]) && gain > most) {
      most = gain;
      best = i;
    }
  }
  return best;
}

/// Goes from `values` towards `target` as far as none falls below zero; classes that come to zero
/// are no longer free. Whether the target was reached.
bool approach(const Row& target, Row& values, std::vector<std::size_t>& free) {
  double way = 1;
  std::size_t first = k_classes;
  for (const std::size_t i : free) {
    if (target[i] < 0 && values[i] / (values[i] - target[i]) < way) {
      way = values[i] / (values[i] - target[i]);
      first = i;
    }
  }
  for (const std::size_t i : free) {
    values[i] += way * (target[i] - values[i]);
  }
  if (first == k_classes) {
    return true;
  }
  values[first] = 0;
  free.erase(std::find(free.begin(), free.end(), first));
  return false;
}

/// Where the sum of squares is least with no value below zero (C. L. Lawson, R. J. Hanson: Solving
/// Least Squares Problems, 1974, algorithm NNLS).
Row least_squares(const NormalEquations& equations) {
  constexpr int k_most_rounds = 10 * static_cast<int>(k_classes);
  Row values{};
  std::vector<std::size_t> free;
  for (int round = 0; round < k_most_rounds; ++round) {
    const std::optional<std::size_t> next = most_gaining(equations, values, free);
    if (!next) {
      break;
    }
    free.push_back(*next);
    while (!approach(solution(equations, free), values, free)) {
    }
  }
  return values;
}

Row row_of(const OperationCosts& costs, Quantity quantity) {
  Row row{};
  std::transform(costs.begin(), costs.end(), row.begin(), quantity);
  return row;
}

/// Moves the origin of the values.
void shift(const Row& origin, NormalEquations& equations) {
  for (std::size_t i = 0; i < k_classes; ++i) {
    for (std::size_t j = 0; j < k_classes; ++j) {
      equations.vector[i] -= equations.matrix[i][j] * origin[j];
    }
  }
}

Row fitted(NormalEquations equations, const OperationCosts& start, const OperationCosts& least,
           Quantity quantity) {
  const Row begin = row_of(start, quantity);
  hold_to(begin, equations);
  const Row lowest = row_of(least, quantity);
  shift(lowest, equations);
  Row values = least_squares(equations);
  for (std::size_t i = 0; i < k_classes; ++i) {
    values[i] = equations.matrix[i][i] == 0 ? begin[i] : values[i] + lowest[i];
  }
  return values;
}

}  // namespace

OperationCosts fitted_costs(const std::vector<CostSample>& samples, const OperationCosts& start,
                            const OperationCosts& least) {
  const Matrix matrix = normal_matrix(samples);
  const auto of = [&](Quantity quantity) {
    return fitted({matrix, normal_vector(samples, quantity)}, start, least, quantity);
  };
  const Row internal = of(internal_clocks);
  const Row read = of(reads);
  const Row written = of(writes);
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
