#include "sim/record/function_work.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "firmware/arithmetic/work.hpp"

namespace maquette::sim {

namespace {

/// The work that a cell of a meter has counted.
firmware::LongWork work_of(const std::uint64_t* counts) {
  firmware::LongWork work{};
  std::copy_n(counts, firmware::k_operation_count, std::begin(work.counts));
  return firmware::general_apart(work);
}

void add(const firmware::ExtentCounts& counts, firmware::ExtentCounts& sum) {
  sum.tests += counts.tests;
  sum.hits += counts.hits;
  sum.spared_leaves += counts.spared_leaves;
}

}  // namespace

void FunctionWork::reach(std::size_t ray_kinds) {
  cells.resize(std::max(cells.size(), ray_kinds * firmware::k_function_count));
}

void FunctionWork::add(firmware::CountedMeter& meter) {
  meter.for_each_cell([this](std::uint32_t cell, const std::uint64_t* counts) {
    reach(1 + cell / firmware::k_function_count);
    const firmware::LongWork work = work_of(counts);
    for (std::size_t i = 0; i < cells[cell].size(); ++i) {
      cells[cell][i] += work.counts[i];
    }
  });
  for (std::size_t kind = 0; kind < extents.size(); ++kind) {
    sim::add(meter.extents[kind], extents[kind]);
  }
  for (int steps = 0; steps < meter.root_steps_end; ++steps) {
    intersection_roots[static_cast<std::size_t>(steps)] += meter.intersection_roots[steps];
  }
}

void FunctionWork::add(const FunctionWork& other) {
  reach(other.ray_kinds());
  for (std::size_t cell = 0; cell < other.cells.size(); ++cell) {
    for (std::size_t i = 0; i < cells[cell].size(); ++i) {
      cells[cell][i] += other.cells[cell][i];
    }
  }
  for (std::size_t kind = 0; kind < extents.size(); ++kind) {
    sim::add(other.extents[kind], extents[kind]);
  }
  for (std::size_t steps = 0; steps < intersection_roots.size(); ++steps) {
    intersection_roots[steps] += other.intersection_roots[steps];
  }
}

namespace {

/// Calls `visit` with each number of the work, in order; those of the cells, of which there may be
/// more, come last.
template <class Work, class Visit>
void for_each_number(Work& work, Visit visit) {
  for (auto& counts : work.extents) {
    visit(counts.tests);
    visit(counts.hits);
    visit(counts.spared_leaves);
  }
  for (auto& roots : work.intersection_roots) {
    visit(roots);
  }
  for (auto& cell : work.cells) {
    for (auto& count : cell) {
      visit(count);
    }
  }
}

/// Makes rows as far as the number of a place; false where none may be.
bool reach_place(std::uint64_t place, FunctionWork& work) {
  const std::uint64_t before_cells =
      3 * work.extents.size() + work.intersection_roots.size();  // each extent has three
  const std::uint64_t row = std::uint64_t{firmware::k_function_count} * firmware::k_operation_count;
  const std::uint64_t ray = place < before_cells ? 0 : (place - before_cells) / row;
  if (ray >= firmware::k_ray_kind_count) {
    return false;
  }
  work.reach(ray + 1);
  return true;
}

}  // namespace

std::vector<std::uint64_t> numbers_of(const FunctionWork& work) {
  std::vector<std::uint64_t> numbers;
  std::uint64_t place = 0;
  for_each_number(work, [&](std::uint64_t number) {
    if (number != 0) {
      numbers.push_back(place);
      numbers.push_back(number);
    }
    ++place;
  });
  return numbers;
}

bool read_numbers(const std::vector<std::uint64_t>& numbers, FunctionWork& work) {
  if (!numbers.empty() && !reach_place(numbers[(numbers.size() - 1) / 2 * 2], work)) {
    return false;
  }
  std::size_t next = 0;
  std::uint64_t place = 0;
  for_each_number(work, [&](std::uint64_t& number) {
    if (next + 1 < numbers.size() && numbers[next] == place) {
      number = numbers[next + 1];
      next += 2;
    }
    ++place;
  });
  return next == numbers.size();
}

FunctionCounts function_counts(firmware::CountedMeter& meter) {
  std::array<std::uint64_t, firmware::k_function_count> sums{};
  meter.for_each_cell([&sums](std::uint32_t cell, const std::uint64_t* counts) {
    const firmware::LongWork work = work_of(counts);
    std::uint64_t& sum = sums[cell % firmware::k_function_count];
    sum = std::accumulate(std::begin(work.counts), std::end(work.counts), sum);
  });
  FunctionCounts functions{};
  static constexpr std::uint64_t k_most = std::numeric_limits<std::uint32_t>::max();
  std::transform(sums.begin(), sums.end(), functions.begin(), [](std::uint64_t sum) {
    return static_cast<std::uint32_t>(std::min(sum, std::uint64_t{k_most}));
  });
  return functions;
}

}  // namespace maquette::sim
