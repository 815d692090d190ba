#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "sim/page/chart.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"

namespace maquette::sim {
namespace {

Html ray_table(const Statistics& statistics) {
  const auto pixels = static_cast<double>(statistics.frame.pixels_synthesised);
  PageTable table{"Rays", {{"rays"}, {"number", true}, {"per pixel", true}}, {}};
  for_each_field<RayStatistics>([&](const auto& kind) {
    const std::int64_t count = statistics.rays.*kind.member;
    table.rows.push_back({kind.member == &RayStatistics::total ? "all" : kind.name,
                          std::to_string(count),
                          fmt::format("{:.3f}", share_of(static_cast<double>(count), pixels))});
  });
  return table_element(table);
}

Html roots(const RootStatistics& statistics) {
  if (!statistics.intersections) {
    return {};
  }
  const IntersectionRoots& found = *statistics.intersections;
  PageTable table{"Roots of intersections by steps of Laguerre's method",
                  {{"steps", true}, {"roots", true}, {"of roots", true}},
                  {}};
  for (const RootsBySteps& row : found.by_steps) {
    table.rows.push_back(
        {std::to_string(row.steps), std::to_string(row.roots),
         percent(share_of(static_cast<double>(row.roots), static_cast<double>(found.found)))});
  }
  return paragraph(fmt::format(
             "{} roots of intersections, {:.2f} steps each: 1 or 2 for {:.1f} %, 3 to 5 for {:.1f} "
             "%, more for {:.2f} %.",
             found.found, found.steps_per_root, 100 * found.up_to_two, 100 * found.three_to_five,
             100 * found.more)) +
         table_element(table);
}

/// The classes of operations, the dearest first.
std::vector<std::size_t> by_clocks(const std::vector<double>& clocks) {
  std::vector<std::size_t> order(clocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&clocks](std::size_t first, std::size_t second) {
    return clocks[first] > clocks[second];
  });
  return order;
}

Html operations(const Statistics& statistics) {
  std::vector<double> clocks;
  for (std::size_t i = 0; i < statistics.work.size(); ++i) {
    clocks.push_back(static_cast<double>(statistics.work[i]) * statistics.costs.clocks[i]);
  }
  const double all = std::accumulate(clocks.begin(), clocks.end(), 0.0);
  Chart chart{"operations-chart",
              "Clocks of all boards by class of operation",
              "The table below has it.",
              ChartKind::bars,
              "clocks",
              ""};
  chart.series.push_back({"clocks", {}, {}});
  PageTable table{"Work by class of operation",
                  {{"work"},
                   {"number", true},
                   {"clocks each", true},
                   {"of counted clocks", true},
                   {"before the frame, each board", true}},
                  {}};
  for (const std::size_t i : by_clocks(clocks)) {
    const char* name = firmware::k_operation_names[i];
    if (clocks[i] > 0) {
      chart.labels.emplace_back(name);
      chart.series.front().values.push_back(clocks[i]);
    }
    table.rows.push_back(
        {name, std::to_string(statistics.work[i]), fmt::format("{:g}", statistics.costs.clocks[i]),
         percent(share_of(clocks[i], all)), std::to_string(statistics.preprocess_work[i])});
  }
  return chart_element(chart) + table_element(table);
}

Html extents(const ExtentStatistics& statistics) {
  PageTable table{"Rays compared with extents",
                  {{"extents"}, {"comparisons", true}, {"hits", true}, {"leaves spared", true}},
                  {}};
  for_each_field<ExtentStatistics>([&](const auto& kind) {
    const ExtentTests& tests = statistics.*kind.member;
    if (tests.tests > 0) {
      table.rows.push_back({kind.name, std::to_string(tests.tests), std::to_string(tests.hits),
                            std::to_string(tests.spared_leaves)});
    }
  });
  return table.rows.empty() ? Html{} : table_element(table);
}

}  // namespace

Html work_section(const RunResults& results) {
  const Statistics& statistics = results.statistics;
  return ray_table(statistics) + extents(statistics.extents) + roots(statistics.roots) +
         operations(statistics);
}

}  // namespace maquette::sim
