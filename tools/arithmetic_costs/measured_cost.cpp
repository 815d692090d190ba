#include "tools/arithmetic_costs/measured_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace maquette::costs {

MeasuredCost measure(int executions, const std::function<Execution()>& execute) {
  std::uint64_t cycles = 0;
  std::uint64_t squares = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
  MeasuredCost cost;
  cost.least = std::numeric_limits<std::uint64_t>::max();
  for (int i = 0; i < executions; ++i) {
    const Execution execution = execute();
    cycles += execution.cycles;
    squares += execution.cycles * execution.cycles;
    reads += execution.reads;
    writes += execution.writes;
    cost.least = std::min(cost.least, execution.cycles);
    cost.most = std::max(cost.most, execution.cycles);
  }
  const auto mean = [executions](std::uint64_t sum) {
    return static_cast<double>(sum) / executions;
  };
  cost.mean = mean(cycles);
  cost.deviation = std::sqrt(std::max(0.0, mean(squares) - cost.mean * cost.mean));
  cost.reads = mean(reads);
  cost.writes = mean(writes);
  return cost;
}

}  // namespace maquette::costs
