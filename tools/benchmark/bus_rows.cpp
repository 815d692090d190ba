#include <string>

#include "tools/benchmark/median.hpp"
#include "tools/benchmark/rows.hpp"
#include "tools/benchmark/simulation_process.hpp"

namespace maquette::benchmark {

namespace {

constexpr int k_repetitions = 5;

double processor_time_s(const Paths& paths, const std::string& level) {
  return run_simulation(paths, "bus_" + level, {"--bus", level}).processor_time_s;
}

}  // namespace

std::vector<Row> measure_bus_levels(const Paths& paths) {
  std::vector<double> ratios;
  for (int i = 0; i < k_repetitions; ++i) {
    const double transaction_s = processor_time_s(paths, "transaction");
    ratios.push_back(processor_time_s(paths, "signal") / transaction_s);
  }
  return {{"signal_over_transaction", median(ratios), "1", std::nullopt,
           "whole process, one thread, processor time: the bus as lines over the bus as accesses"}};
}

}  // namespace maquette::benchmark
