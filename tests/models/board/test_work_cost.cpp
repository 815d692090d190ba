#include <limits>
#include <stdexcept>

#include "models/board/work_cost.hpp"
#include "tests/catch.hpp"

namespace {

using namespace maquette::models;
using maquette::firmware::Operation;
using maquette::firmware::Work;

Kvm02Parameters board() {
  Kvm02Parameters parameters;
  const auto add = static_cast<std::size_t>(Operation::add);
  const auto branch = static_cast<std::size_t>(Operation::node);
  parameters.arithmetic.operations[add] = {165.4, 30.5, 2};
  parameters.arithmetic.called[add] = true;
  parameters.arithmetic.operations[branch] = {10, 2, 1};
  parameters.call_overhead = {68, 13, 4};
  return parameters;
}

TEST_CASE("a work's time is what one computes by hand") {
  const WorkCost cost(board());
  // add: 165.4 + 30.5 * 2 + 2 * 1, and the call 68 + 13 * 2 + 4 * 1; branch: 10 + 2 * 2 + 1.
  CHECK(cost.milliclocks(Operation::add) == 326'400);
  CHECK(cost.milliclocks(Operation::node) == 15'000);
  CHECK(cost.milliclocks(Operation::divide) == 0);
  Work work{};
  work[Operation::add] = 1000;
  work[Operation::node] = 40;
  // 327 000 clocks of 125 ns; of every 15 us 4 clocks (0.5 us) are stolen.
  CHECK(cost.duration(work) == Duration{327'000LL * 125'000 * 150 / 145});
  CHECK(cost.duration(Work{}) == Duration::zero());
}

TEST_CASE("without refresh the processor has all its time") {
  Kvm02Parameters parameters = board();
  parameters.refresh_period = Duration::zero();
  Work work{};
  work[Operation::node] = 7;
  CHECK(WorkCost(parameters).duration(work) == Duration{7 * 15 * 125'000});
}

TEST_CASE("odd clocks and the largest work stay exact") {
  Kvm02Parameters parameters = board();
  parameters.clock_hz = 14.318181e6;
  parameters.refresh_period = Duration{15'625'001};
  const WorkCost cost(parameters);
  Work work{};
  work[Operation::node] = 4'000'000'000U;
  const long double clocks = 15.0L * 4'000'000'000U;
  const long double clock_ps = 1e12L / 14318181.0L;
  const long double expected = clocks * clock_ps / (1 - 4 * clock_ps / 15'625'001.0L);
  CHECK(static_cast<double>(cost.duration(work).count() - expected) == Approx(0).margin(2));
}

TEST_CASE("work that is longer than any time takes the longest") {
  Kvm02Parameters parameters = board();
  parameters.clock_hz = 1e3;
  parameters.refresh_period = Duration{1'000'000'000'000};
  for (OperationCost& cost : parameters.arithmetic.operations) {
    cost = {1e7, 1e7, 1e7};
  }
  Work work{};
  for (std::uint32_t& count : work.counts) {
    count = 4'294'967'295U;
  }
  CHECK(WorkCost(parameters).milliclocks(work) == std::numeric_limits<std::int64_t>::max());
  CHECK(WorkCost(parameters).duration(work) == Duration::max());
}

TEST_CASE("refresh of odd clocks and long periods stays exact") {
  Kvm02Parameters parameters = board();
  parameters.clock_hz = 999'999'999.989;
  parameters.refresh_period = Duration{999'999'999'989};
  parameters.refresh_clocks = 100'000;
  Work work{};
  work[Operation::node] = 4'000'000'000U;
  const long double clocks = 15.0L * 4'000'000'000U;
  const long double clock_ps = 1e12L / 999'999'999.989L;
  const long double expected = clocks * clock_ps / (1 - 100'000 * clock_ps / 999'999'999'989.0L);
  CHECK(static_cast<double>(static_cast<long double>(WorkCost(parameters).duration(work).count()) -
                            expected) == Approx(0).margin(2));
}

TEST_CASE("costs that make no sense are refused") {
  Kvm02Parameters parameters = board();
  parameters.refresh_clocks = 120;  // all of 15 us
  CHECK_THROWS_AS(WorkCost(parameters), std::invalid_argument);
  parameters = board();
  parameters.arithmetic.operations[0].clocks = -1000;
  CHECK_THROWS_WITH(WorkCost(parameters), Catch::Matchers::ContainsSubstring("add"));
}

}  // namespace
