#include "sim/run/price_fit.hpp"

#include <random>

#include "tests/catch.hpp"

using namespace maquette;
using firmware::Operation;

namespace {

double& price_of(sim::Prices& prices, Operation operation) {
  return prices[static_cast<std::size_t>(operation)];
}

sim::Prices some_prices(std::mt19937& generator) {
  std::uniform_real_distribution<double> price(0, 500'000);
  sim::Prices prices{};
  for (double& each : prices) {
    each = price(generator);
  }
  return prices;
}

std::vector<sim::PricedWork> samples_at(const sim::Prices& prices, std::mt19937& generator) {
  std::uniform_int_distribution<std::uint32_t> count(0, 300);
  std::vector<sim::PricedWork> samples(400);
  for (sim::PricedWork& sample : samples) {
    for (std::uint32_t& each : sample.work.counts) {
      each = count(generator);
    }
    sample.milliclocks = sim::cost(sample.work, prices);
  }
  return samples;
}

TEST_CASE("prices that samples were made with are found again") {
  std::mt19937 generator(31);
  for (int trial = 0; trial < 10; ++trial) {
    const sim::Prices prices = some_prices(generator);
    const std::vector<sim::PricedWork> samples = samples_at(prices, generator);
    const sim::Prices found = sim::fitted_prices(samples, sim::Prices{});
    for (std::size_t i = 0; i < prices.size(); ++i) {
      CHECK(found[i] == Approx(prices[i]).epsilon(1e-3).margin(500));
    }
  }
}

TEST_CASE("no price is negative, and what no sample has stays as it was") {
  std::mt19937 generator(32);
  const sim::Prices prices = some_prices(generator);
  std::vector<sim::PricedWork> samples = samples_at(prices, generator);
  for (sim::PricedWork& sample : samples) {
    sample.milliclocks -= 1e6 * sample.work[Operation::load];
    sample.work[Operation::divide] = 0;
  }
  sim::Prices start{};
  price_of(start, Operation::divide) = 1234;
  sim::Prices found = sim::fitted_prices(samples, start);
  for (const double price : found) {
    CHECK(price >= 0);
  }
  CHECK(price_of(found, Operation::load) == 0);
  CHECK(price_of(found, Operation::divide) == 1234);
}

TEST_CASE("classes that always come together share what they cost, near where they start") {
  std::vector<sim::PricedWork> samples(10);
  for (std::uint32_t i = 0; i < 10; ++i) {
    samples[i].work = {};
    samples[i].work[Operation::load] = i;
    samples[i].work[Operation::store] = i;
    samples[i].milliclocks = 30'000.0 * i;
  }
  sim::Prices start{};
  price_of(start, Operation::load) = 12'000;
  price_of(start, Operation::store) = 16'000;
  sim::Prices found = sim::fitted_prices(samples, start);
  const double load = price_of(found, Operation::load);
  const double store = price_of(found, Operation::store);
  CHECK(load + store == Approx(30'000).epsilon(1e-3));
  CHECK(load > 10'000);
  CHECK(store > 14'000);
}

TEST_CASE("no samples leave the prices as they are") {
  std::mt19937 generator(33);
  const sim::Prices start = some_prices(generator);
  CHECK(sim::fitted_prices({}, start) == start);
}

}  // namespace
