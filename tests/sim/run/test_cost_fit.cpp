#include "sim/run/cost_fit.hpp"

#include <random>

#include "tests/catch.hpp"

using namespace maquette;
using firmware::Operation;
using models::OperationCost;

namespace {

OperationCost& cost_for(sim::OperationCosts& costs, Operation operation) {
  return costs[static_cast<std::size_t>(operation)];
}

/// Costs of instructions: no more bus cycles than clocks have room for.
sim::OperationCosts some_costs(std::mt19937& generator) {
  std::uniform_real_distribution<double> accesses(0, 60);
  std::uniform_real_distribution<double> internal(0, 300);
  sim::OperationCosts costs{};
  for (OperationCost& cost : costs) {
    cost.reads = accesses(generator);
    cost.writes = accesses(generator);
    cost.clocks = internal(generator) + 4 * (cost.reads + cost.writes);
  }
  return costs;
}

std::vector<sim::CostSample> samples_at(const sim::OperationCosts& costs, std::mt19937& generator) {
  std::uniform_int_distribution<std::uint32_t> count(0, 300);
  std::vector<sim::CostSample> samples(600);
  for (sim::CostSample& sample : samples) {
    for (std::uint32_t& each : sample.work.counts) {
      each = count(generator);
    }
    sample.taken = sim::cost_of(sample.work, costs);
  }
  return samples;
}

TEST_CASE("costs that samples were made with are found again") {
  std::mt19937 generator(31);
  for (int trial = 0; trial < 10; ++trial) {
    const sim::OperationCosts costs = some_costs(generator);
    const sim::OperationCosts found =
        sim::fitted_costs(samples_at(costs, generator), sim::OperationCosts{}, {});
    for (std::size_t i = 0; i < costs.size(); ++i) {
      CHECK(found[i].clocks == Approx(costs[i].clocks).epsilon(1e-3).margin(0.5));
      CHECK(found[i].reads == Approx(costs[i].reads).epsilon(1e-3).margin(0.5));
      CHECK(found[i].writes == Approx(costs[i].writes).epsilon(1e-3).margin(0.5));
    }
  }
}

TEST_CASE(
    "no cost is below its least nor without time for its bus cycles; what no sample has stays") {
  std::mt19937 generator(32);
  const sim::OperationCosts costs = some_costs(generator);
  std::vector<sim::CostSample> samples = samples_at(costs, generator);
  for (sim::CostSample& sample : samples) {
    sample.taken.clocks -= 1e4 * sample.work[Operation::load];
    sample.taken.reads -= 100 * sample.work[Operation::load];
    sample.work[Operation::divide] = 0;
  }
  sim::OperationCosts start{};
  cost_for(start, Operation::divide) = {1234, 12, 3};
  sim::OperationCosts least{};
  cost_for(least, Operation::load) = {8, 2, 0};
  sim::OperationCosts found = sim::fitted_costs(samples, start, least);
  for (const OperationCost& cost : found) {
    CHECK(cost.reads >= 0);
    CHECK(cost.writes >= 0);
    CHECK(cost.clocks + 1e-9 >= 4 * (cost.reads + cost.writes));
  }
  CHECK(cost_for(found, Operation::load).reads == 2);
  CHECK(cost_for(found, Operation::load).clocks == 8 + 4 * cost_for(found, Operation::load).writes);
  CHECK(cost_for(found, Operation::divide).clocks == 1234);
  CHECK(cost_for(found, Operation::divide).reads == 12);
  CHECK(cost_for(found, Operation::divide).writes == 3);
}

/// Of clocks without bus cycles.
double sum_of_squares(const std::vector<sim::CostSample>& samples,
                      const sim::OperationCosts& costs) {
  double sum = 0;
  for (const sim::CostSample& sample : samples) {
    const double error = sim::cost_of(sample.work, costs).clocks - sample.taken.clocks;
    sum += error * error;
  }
  return sum;
}

TEST_CASE("no other allowed cost of a class fits better") {
  std::mt19937 generator(35);
  std::uniform_real_distribution<double> noise(-50'000, 50'000);
  std::uniform_real_distribution<double> bound(0, 700);
  int held = 0;
  for (int trial = 0; trial < 10; ++trial) {
    sim::OperationCosts costs = some_costs(generator);
    sim::OperationCosts least{};
    for (std::size_t i = 0; i < costs.size(); ++i) {
      costs[i] = {costs[i].clocks, 0, 0};
      least[i].clocks = bound(generator);
    }
    std::vector<sim::CostSample> samples = samples_at(costs, generator);
    for (sim::CostSample& sample : samples) {
      sample.taken.clocks += noise(generator);
    }
    const sim::OperationCosts found = sim::fitted_costs(samples, least, least);
    const double best = sum_of_squares(samples, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
      sim::OperationCosts other = found;
      other[i].clocks += 2;
      CHECK(sum_of_squares(samples, other) > best);
      other[i].clocks = found[i].clocks - 2;
      const bool is_allowed = other[i].clocks >= least[i].clocks;
      held += is_allowed ? 0 : 1;
      CHECK((!is_allowed || sum_of_squares(samples, other) > best));
    }
  }
  CHECK(held > 20);
}

TEST_CASE("classes that always come together share what they cost, near where they start") {
  std::vector<sim::CostSample> samples(10);
  for (std::uint32_t i = 0; i < 10; ++i) {
    samples[i].work = {};
    samples[i].work[Operation::load] = i;
    samples[i].work[Operation::node] = i;
    samples[i].taken.clocks = 30.0 * i;
  }
  sim::OperationCosts start{};
  cost_for(start, Operation::load).clocks = 12;
  cost_for(start, Operation::node).clocks = 16;
  sim::OperationCosts found = sim::fitted_costs(samples, start, {});
  const double load = cost_for(found, Operation::load).clocks;
  const double node = cost_for(found, Operation::node).clocks;
  CHECK(load + node == Approx(30).epsilon(1e-3));
  CHECK(load > 10);
  CHECK(node > 14);
}

TEST_CASE("a sample's weight is as if it came so often") {
  std::mt19937 generator(34);
  std::uniform_real_distribution<double> noise(-500, 500);
  std::vector<sim::CostSample> samples = samples_at(some_costs(generator), generator);
  for (sim::CostSample& sample : samples) {
    sample.taken.clocks += noise(generator);
  }
  std::vector<sim::CostSample> repeated = samples;
  for (std::size_t i = 0; i < samples.size(); i += 3) {
    samples[i].weight = 2;
    repeated.push_back(repeated[i]);
  }
  const sim::OperationCosts weighed = sim::fitted_costs(samples, {}, {});
  const sim::OperationCosts counted = sim::fitted_costs(repeated, {}, {});
  for (std::size_t i = 0; i < weighed.size(); ++i) {
    CHECK(weighed[i].clocks == Approx(counted[i].clocks).epsilon(1e-5).margin(1e-3));
  }
}

TEST_CASE("no samples leave the costs as they are") {
  std::mt19937 generator(33);
  const sim::OperationCosts start = some_costs(generator);
  const sim::OperationCosts found = sim::fitted_costs({}, start, {});
  for (std::size_t i = 0; i < start.size(); ++i) {
    CHECK(found[i].clocks == Approx(start[i].clocks));
    CHECK(found[i].reads == start[i].reads);
  }
}

}  // namespace
