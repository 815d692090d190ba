#include "models/board/work_cost.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "models/bus/wide.hpp"

namespace maquette::models {

namespace {

constexpr double k_milli = 1e3;
constexpr std::int64_t k_clock_per_milliclock = 1'000;
constexpr std::int64_t k_ps_millihertz = 1'000'000'000'000'000;
constexpr std::int64_t k_largest = std::numeric_limits<std::int64_t>::max();

double clocks_with_waits(const OperationCost& cost, const Kvm02Parameters& board) {
  return cost.clocks + cost.reads * static_cast<double>(board.ram_read_wait_clocks) +
         cost.writes * static_cast<double>(board.ram_write_wait_clocks);
}

Period milliclock(const Kvm02Parameters& board) {
  const auto millihertz = std::llround(board.clock_hz * k_milli);
  return {k_ps_millihertz / k_clock_per_milliclock, millihertz};
}

// As 64 bits hold it: exactly, or where they do not to 62 bits of the numerator.
Period ratio(Wide numerator, Wide denominator) {
  Wide divisor = numerator;
  for (Wide rest = denominator; rest != 0;) {
    divisor = std::exchange(rest, divisor % rest);
  }
  numerator /= divisor;
  denominator /= divisor;
  while (numerator > k_largest) {
    numerator /= 2;
    denominator = (denominator + 1) / 2;
  }
  return {static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(denominator)};
}

// Of a refresh period P the processor has P - c T, T being its clock period: P / (P - c T), both
// times the clock's frequency.
Period elapsed_per_processor_ps(const Kvm02Parameters& board) {
  if (board.refresh_period <= Duration::zero()) {
    return {1, 1};
  }
  const Wide whole =
      static_cast<Wide>(board.refresh_period.count()) * std::llround(board.clock_hz * k_milli);
  const Wide stolen = static_cast<Wide>(board.refresh_clocks) * k_ps_millihertz;
  if (stolen < 0 || stolen >= whole) {
    throw std::invalid_argument("RAM refresh must leave the processor some of its time");
  }
  return ratio(whole, whole - stolen);
}

template <class Sum, class Costs>
Sum sum_of_products(const Costs& costs, const firmware::Work& work) {
  Sum sum = 0;
  for (std::size_t operation = 0; operation < costs.size(); ++operation) {
    sum += static_cast<Sum>(costs[operation]) * work.counts[operation];
  }
  return sum;
}

}  // namespace

WorkCost::WorkCost(const Kvm02Parameters& board)
    : datum_milliclocks_(std::llround(clocks_with_waits(board.database_read, board) * k_milli)),
      milliclock_(milliclock(board)),
      elapsed_per_processor_ps_(elapsed_per_processor_ps(board)) {
  const double call = clocks_with_waits(board.call_overhead, board);
  for (std::size_t operation = 0; operation < milliclocks_.size(); ++operation) {
    const double clocks = clocks_with_waits(board.arithmetic.operations[operation], board) +
                          (board.arithmetic.called[operation] ? call : 0);
    if (!(clocks >= 0)) {
      throw std::invalid_argument(std::string("the cost of ") +
                                  firmware::k_operation_names[operation] + " must not be negative");
    }
    milliclocks_[operation] = std::llround(clocks * k_milli);
  }
  Wide most = 0;
  for (const std::int64_t milliclocks : milliclocks_) {
    most += static_cast<Wide>(milliclocks) * std::numeric_limits<std::uint32_t>::max();
  }
  sums_fit_ = most < k_largest;
  if (is_shared(board.database) && milliclocks(firmware::Operation::load) < datum_milliclocks_) {
    throw std::invalid_argument("board.database_read must not cost more than a load");
  }
}

std::int64_t WorkCost::milliclocks(const firmware::Work& work) const {
  if (sums_fit_) {
    return sum_of_products<std::int64_t>(milliclocks_, work);
  }
  const Wide sum = sum_of_products<Wide>(milliclocks_, work);
  return sum < k_largest ? static_cast<std::int64_t>(sum) : k_largest;
}

Duration WorkCost::duration(const firmware::Work& work, std::int64_t bus_loads) const {
  return elapsed(milliclocks(work) - datum_milliclocks_ * bus_loads);
}

}  // namespace maquette::models
