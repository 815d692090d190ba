#include "sim/run/function_times.hpp"

#include <algorithm>

#include "models/board/work_cost.hpp"
#include "models/bus/wide.hpp"
#include "sim/run/proportional_shares.hpp"

namespace maquette::sim {

namespace {

using firmware::RayKind;
using Counts = FunctionWork::Counts;

/// The preprocessing is no ray; it comes first.
constexpr std::size_t row_of(RayKind kind) { return 1 + static_cast<std::size_t>(kind); }

void add(const Counts& counts, std::uint64_t times, Counts& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += times * counts[i];
  }
}

/// The work of a frame as a table: a row for the preprocessing of all boards and for each kind of
/// ray, a column for each function.
class WorkTable {
 public:
  WorkTable(const FrameWork& work, std::size_t boards)
      : rows_(1 + work.pixels.ray_kinds()), cells_(rows_ * k_columns) {
    for (std::size_t function = 0; function < k_columns; ++function) {
      for (std::size_t ray = 0; ray < work.preprocessing.ray_kinds(); ++ray) {
        add(work.preprocessing.cells[FunctionWork::cell(ray, function)], boards, cells_[function]);
      }
      for (std::size_t ray = 0; ray < work.pixels.ray_kinds(); ++ray) {
        add(work.pixels.cells[FunctionWork::cell(ray, function)], 1,
            cells_[(1 + ray) * k_columns + function]);
      }
    }
  }

  static constexpr auto k_columns = static_cast<std::size_t>(k_told_function_count);

  [[nodiscard]] const std::vector<Counts>& cells() const { return cells_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  /// Nothing where there is none.
  [[nodiscard]] Counts row(std::size_t row) const {
    Counts sum{};
    if (row >= rows_) {
      return sum;
    }
    for (std::size_t column = 0; column < k_columns; ++column) {
      add(cells_[row * k_columns + column], 1, sum);
    }
    return sum;
  }

  [[nodiscard]] Counts column(std::size_t column) const {
    Counts sum{};
    for (std::size_t row = 0; row < rows_; ++row) {
      add(cells_[row * k_columns + column], 1, sum);
    }
    return sum;
  }

 private:
  std::size_t rows_;
  std::vector<Counts> cells_;
};

models::Wide price_of(const Counts& counts, const models::WorkCost& cost) {
  models::Wide price = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    price += static_cast<models::Wide>(cost.milliclocks(static_cast<firmware::Operation>(i))) *
             static_cast<models::Wide>(counts[i]);
  }
  return price;
}

/// Of a board in the mean, to the nearest tick.
models::Duration working_time(const models::MachineStatistics& model) {
  models::Wide sum_ps = 0;
  for (const models::BoardStatistics& board : model.boards) {
    sum_ps += board.working.count();
  }
  const auto boards = static_cast<models::Wide>(model.boards.size());
  return models::Duration(static_cast<models::Duration::rep>((sum_ps + boards / 2) / boards));
}

/// The time of a cell goes to its function and to its kind of ray.
void put(std::size_t row, std::size_t column, models::Duration time, FunctionStatistics& result) {
  result.by_function.values[column] += time;
  if (row == 0) {
    result.by_ray.preprocessing += time;
  } else if (row == row_of(RayKind::primary)) {
    result.by_ray.primary += time;
  } else if (row == row_of(RayKind::reflected)) {
    result.by_ray.reflected += time;
  } else if (row == row_of(RayKind::refracted)) {
    result.by_ray.refracted += time;
  } else {
    result.by_ray.shadow += time;
    const std::size_t light = row - row_of(RayKind::shadow);
    if (time > models::Duration::zero()) {
      result.shadow_by_light.resize(std::max(result.shadow_by_light.size(), light + 1));
      result.shadow_by_light[light] += time;
    }
  }
}

bool is_empty(const Counts& counts) {
  return std::all_of(counts.begin(), counts.end(), [](std::uint64_t count) { return count == 0; });
}

void list(std::string name, const Counts& work, std::vector<NamedWork>& list) {
  if (!is_empty(work)) {
    list.push_back({std::move(name), work});
  }
}

void list_work(const WorkTable& table, FunctionStatistics& result) {
  for (std::size_t column = 0; column < WorkTable::k_columns; ++column) {
    list(function_name(static_cast<int>(column)), table.column(column), result.work_by_function);
  }
  list("preprocessing", table.row(0), result.work_by_ray);
  list("primary", table.row(row_of(RayKind::primary)), result.work_by_ray);
  list("reflected", table.row(row_of(RayKind::reflected)), result.work_by_ray);
  list("refracted", table.row(row_of(RayKind::refracted)), result.work_by_ray);
  Counts shadow{};
  for (std::size_t row = row_of(RayKind::shadow); row < table.rows(); ++row) {
    add(table.row(row), 1, shadow);
  }
  list("shadow", shadow, result.work_by_ray);
}

double intersection_share(const FunctionStatistics& statistics) {
  models::Duration intersections{};
  for (std::size_t function = firmware::k_fixed_function_count; function < WorkTable::k_columns;
       ++function) {
    intersections += statistics.by_function.values[function];
  }
  return statistics.time == models::Duration::zero()
             ? 0
             : static_cast<double>(intersections.count()) /
                   static_cast<double>(statistics.time.count());
}

}  // namespace

FunctionStatistics function_statistics(const models::MachineStatistics& model,
                                       const Machine& machine, const FrameWork& work) {
  FunctionStatistics result;
  result.from = "counted work at the prices of the pixels";
  result.time = working_time(model);
  const WorkTable table(work, model.boards.size());
  const models::WorkCost cost(machine.parameters.board);
  std::vector<models::Wide> prices;
  for (const Counts& counts : table.cells()) {
    prices.push_back(price_of(counts, cost));
  }
  const std::vector<models::Duration> times = proportional_shares(result.time, prices);
  for (std::size_t cell = 0; cell < times.size(); ++cell) {
    put(cell / WorkTable::k_columns, cell % WorkTable::k_columns, times[cell], result);
  }
  result.intersection_share = intersection_share(result);
  list_work(table, result);
  return result;
}

ExtentStatistics extent_statistics(const FrameWork& work) {
  const auto told = [&work](firmware::ExtentKind kind) {
    const firmware::ExtentCounts& counts = work.pixels.extents[static_cast<std::size_t>(kind)];
    return ExtentTests{counts.tests, counts.hits, counts.spared_leaves};
  };
  return {told(firmware::ExtentKind::rectangle), told(firmware::ExtentKind::box),
          told(firmware::ExtentKind::sphere)};
}

std::optional<IntersectionRoots> intersection_roots(const FrameWork& work) {
  IntersectionRoots roots;
  std::uint64_t few = 0;
  std::uint64_t many = 0;
  for (std::size_t steps = 0; steps < work.pixels.intersection_roots.size(); ++steps) {
    const std::uint64_t count = work.pixels.intersection_roots[steps];
    if (count == 0) {
      continue;
    }
    roots.found += count;
    roots.steps += count * steps;
    few += steps < 3 ? count : 0;
    many += steps > 5 ? count : 0;
    roots.by_steps.push_back({static_cast<int>(steps), count});
  }
  if (roots.found == 0) {
    return std::nullopt;
  }
  const auto all = static_cast<double>(roots.found);
  roots.steps_per_root = static_cast<double>(roots.steps) / all;
  roots.up_to_two = static_cast<double>(few) / all;
  roots.three_to_five = static_cast<double>(roots.found - few - many) / all;
  roots.more = static_cast<double>(many) / all;
  return roots;
}

}  // namespace maquette::sim
