#pragma once

#include <array>
#include <vector>

#include "firmware/arithmetic/work.hpp"
#include "models/board/arithmetic_costs.hpp"

namespace maquette::sim {

/// A cost per operation class.
using OperationCosts = std::array<models::OperationCost, firmware::k_operation_count>;

/// What a pixel was counted to do, and what its execution took.
struct CostSample {
  firmware::Work work;
  models::OperationCost taken;
  double weight = 1;  ///< of its squared error
};

/// The costs that come nearest to what the samples took, in the sense of least squares, each no
/// less than `least` and with four clocks for each of its reads and writes (a bus cycle of the
/// MC68000). Where samples do not tell (classes that none has, or that come together in all), they
/// stay near `start`. Deterministic.
OperationCosts fitted_costs(const std::vector<CostSample>& samples, const OperationCosts& start,
                            const OperationCosts& least);

/// What work costs.
models::OperationCost cost_of(const firmware::Work& work, const OperationCosts& costs);

}  // namespace maquette::sim
