#include <cmath>

#include "models/bus/arbitration_policies.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

// Mean rates in 1/ps.
constexpr double k_service_ps = 1e6;

// Probability that the server of a machine-repairman queue M/G/1//N works (Takacs 1962).
// `growth(i)` is (1 - B(i l)) / B(i l) with B the Laplace transform of the service time, l the rate
// of thinking.
double utilisation(int masters, double thinking_rate, double (*growth)(double)) {
  double sum = 0;
  double choose_n = 1;
  double product = 1;
  for (int n = 0; n < masters; ++n) {
    sum += choose_n * product;
    choose_n = choose_n * (masters - 1 - n) / (n + 1);
    product *= growth((n + 1) * thinking_rate);
  }
  return 1 - 1 / (1 + masters * thinking_rate * k_service_ps * sum);
}

double exponential_growth(double rate) { return rate * k_service_ps; }
double deterministic_growth(double rate) { return std::exp(rate * k_service_ps) - 1; }

double exponential(std::mt19937& generator, double mean) {
  return -mean * std::log(unit(generator));
}

// A processor of which a clock is a tick: its access lasts as long as the slave's, and a tick.
AccessLaw immediate() { return {Period::of_frequency(1e12), 1, Duration{0}}; }

Step thinking(std::mt19937& generator, double mean) {
  Step step;
  step.compute = Duration{std::llround(exponential(generator, mean))};
  return step;
}

// Mean and 99.9 % confidence half-width of the throughput over batches, in accesses per service
// time.
struct Estimate {
  double mean;
  double half_width;
};

Estimate throughput(const std::vector<BusAccess>& log, std::size_t batches) {
  const std::size_t batch = log.size() / batches;
  double sum = 0;
  double squares = 0;
  for (std::size_t one = 1; one < batches; ++one) {  // the first one warms up
    const Duration span = log[(one + 1) * batch - 1].end - log[one * batch - 1].end;
    const double rate =
        static_cast<double>(batch) * k_service_ps / static_cast<double>(span.count());
    sum += rate;
    squares += rate * rate;
  }
  const auto n = static_cast<double>(batches - 1);
  const double mean = sum / n;
  const double variance = (squares - n * mean * mean) / (n - 1);
  constexpr double k_student_30 = 3.646;  // two-sided 99.9 %, 30 degrees of freedom
  return {mean, k_student_30 * std::sqrt(variance / n)};
}

TEST_CASE("machine repairman: throughput of masters that think exponentially") {
  struct Case {
    int masters;
    double thinking_ps;
    bool exponential_service;
    ArbitrationPolicy policy;
  };
  const Case cases[] = {
      {1, 2e6, true, k_priority},    {4, 4e6, true, k_priority},  {4, 4e6, true, k_round_robin},
      {8, 5e6, true, k_round_robin}, {4, 4e6, false, k_priority}, {8, 9e6, false, k_round_robin},
  };
  std::mt19937 generator(1912);
  std::vector<std::unique_ptr<Bench>> benches;
  constexpr int k_accesses = 60'000;
  for (const Case& one : cases) {
    VersaBusParameters parameters;
    parameters.arbitration = one.policy;
    parameters.arbitration_clocks = 0;
    parameters.handover_clocks = 0;
    const auto service = [&generator, random = one.exponential_service](Instant /*strobe*/) {
      return Duration{std::llround(random ? exponential(generator, k_service_ps) : k_service_ps)};
    };
    benches.push_back(
        std::make_unique<Bench>("queue" + std::to_string(benches.size()), parameters, service));
    for (int master = 0; master < one.masters; ++master) {
      benches.back()->add(
          {master % 5, master / 5}, Style::promised,
          [&log = benches.back()->log, &generator, mean = one.thinking_ps](Step& step) {
            step = thinking(generator, mean);
            return log.size() < k_accesses;
          },
          immediate());
    }
  }
  sc_core::sc_start();
  for (std::size_t one = 0; one < benches.size(); ++one) {
    const double expected =
        utilisation(cases[one].masters, 1 / cases[one].thinking_ps,
                    cases[one].exponential_service ? exponential_growth : deterministic_growth);
    const Estimate measured = throughput(benches[one]->log, 32);
    INFO("case " << one << ": " << measured.mean << " +- " << measured.half_width);
    CHECK(measured.half_width < 0.02);
    CHECK(std::fabs(measured.mean - expected) < measured.half_width);
    // Little's law: a master either thinks, waits or transfers.
    const BusMasterStatistics sum = total(benches[one]->bus.statistics());
    const double cycle =
        static_cast<double>((sum.waited + sum.busy).count()) / static_cast<double>(sum.transfers) +
        cases[one].thinking_ps;
    CHECK(cases[one].masters * k_service_ps / cycle ==
          Approx(expected).margin(2 * measured.half_width));
  }
}

}  // namespace
