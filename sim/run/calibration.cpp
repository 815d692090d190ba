#include "sim/run/calibration.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/run/execution_check.hpp"
#include "sim/run/program_samples.hpp"

namespace maquette::sim {

namespace {

using models::OperationCost;

OperationCost operator+(const OperationCost& a, const OperationCost& b) {
  return {a.clocks + b.clocks, a.reads + b.reads, a.writes + b.writes};
}

/// Whether the host executes an operation, which then costs what the machine's table says, besides
/// what the program takes around the call.
bool is_priced(const models::ArithmeticCosts& arithmetic, std::size_t operation) {
  return arithmetic.execution == models::ArithmeticExecution::costs && arithmetic.called[operation];
}

/// What the tables say of the program's part.
OperationCosts table_costs(const models::Kvm02Parameters& board) {
  OperationCosts costs{};
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const OperationCost own =
        is_priced(board.arithmetic, i) ? OperationCost{} : board.arithmetic.operations[i];
    costs[i] = own + (board.arithmetic.called[i] ? board.call_overhead : OperationCost{});
  }
  return costs;
}

/// A word of the database is read, whatever else the program does on the occasion.
OperationCosts least_costs() {
  OperationCosts costs{};
  costs[static_cast<std::size_t>(firmware::Operation::load)] =
      models::Kvm02Parameters{}.database_read;
  return costs;
}

void judge(const std::vector<CostSample>& samples, Calibration& calibration) {
  double sum = 0;
  double difference = 0;
  double squares = 0;
  for (const CostSample& sample : samples) {
    const double error = cost_of(sample.work, calibration.costs).clocks - sample.taken.clocks;
    sum += sample.taken.clocks;
    difference += error;
    squares += error * error;
  }
  const auto count = static_cast<double>(samples.size());
  calibration.pixels = static_cast<int>(samples.size());
  calibration.sum_error = sum == 0 ? 0 : difference / sum;
  calibration.typical_error = sum == 0 ? 0 : std::sqrt(squares / count) / (sum / count);
}

}  // namespace

bool is_calibrated(const Machine& machine) {
  switch (machine.cost_origin) {
    case CostOrigin::calibrated:
      return !obstacle_to_execution(sample_machine(machine)).has_value();
    case CostOrigin::tables:
      break;
  }
  return false;
}

std::string calibration_key(const Machine& machine) {
  const models::Kvm02Parameters& board = machine.parameters.board;
  std::string key = fmt::format("{} {}", static_cast<int>(board.arithmetic.execution),
                                static_cast<int>(models::numbers_of(board.arithmetic)));
  const OperationCosts costs = table_costs(board);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    key += fmt::format(" {} {} {} {}", costs[i].clocks, costs[i].reads, costs[i].writes,
                       is_priced(board.arithmetic, i));
  }
  return key;
}

Calibration calibrate(const Scene& scene, const Machine& machine) {
  const std::vector<CostSample> samples = program_samples(scene, machine);
  Calibration calibration;
  calibration.costs = fitted_costs(samples, table_costs(machine.parameters.board), least_costs());
  judge(samples, calibration);
  return calibration;
}

Machine with_costs(const Machine& machine, const Calibration& calibration) {
  Machine calibrated = machine;
  models::ArithmeticCosts& costs = calibrated.parameters.board.arithmetic;
  for (std::size_t i = 0; i < calibration.costs.size(); ++i) {
    costs.operations[i] = is_priced(machine.parameters.board.arithmetic, i)
                              ? costs.operations[i] + calibration.costs[i]
                              : calibration.costs[i];
    costs.called[i] = false;
  }
  return calibrated;
}

}  // namespace maquette::sim
