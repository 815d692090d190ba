#pragma once

#include <array>
#include <vector>

#include "firmware/arithmetic/work.hpp"

namespace maquette::sim {

/// Milliclocks per operation class.
using Prices = std::array<double, firmware::k_operation_count>;

/// What a pixel was counted to do, and the milliclocks that it took.
struct PricedWork {
  firmware::Work work;
  double milliclocks;
};

/// The prices that come nearest to what the samples took, in the sense of least squares, none of
/// them negative. Where samples do not tell (classes that none has, or that come together in all),
/// they stay near `start`. Deterministic.
Prices fitted_prices(const std::vector<PricedWork>& samples, const Prices& start);

/// What work costs.
double cost(const firmware::Work& work, const Prices& prices);

}  // namespace maquette::sim
