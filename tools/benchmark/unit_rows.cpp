#include <string>

#include "tools/benchmark/median.hpp"
#include "tools/benchmark/rows.hpp"
#include "tools/benchmark/simulation_process.hpp"

namespace maquette::benchmark {

namespace {

constexpr int k_repetitions = 9;
constexpr double k_bound = 5;

double processor_time_s(const Paths& paths, const std::string& machine) {
  return run_simulation(paths, machine, {"--machine", machine}).processor_time_s;
}

}  // namespace

std::vector<Row> measure_units(const Paths& paths) {
  std::vector<double> ratios;
  for (int i = 0; i < k_repetitions; ++i) {
    const double plain_s = processor_time_s(paths, "ccett-1984");
    ratios.push_back(processor_time_s(paths, "intersection-units") / plain_s);
  }
  return {{"units_over_plain", median(ratios), "1", k_bound,
           "whole process, one thread, processor time: four boards with four units over four"}};
}

}  // namespace maquette::benchmark
