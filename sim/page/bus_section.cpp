#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "sim/page/bus_over_time.hpp"
#include "sim/page/chart.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/page/wait_matrix.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

Html figures_of(const BusStatistics& bus) {
  std::vector<std::pair<std::string, std::string>> rows{
      {"Transfers", std::to_string(bus.transfers)},
      {"Occupied", fmt::format("{} of the frame; transfers take {}", percent(bus.occupied, 3),
                               readable_duration(bus.busy))},
      {"Wait for grant", fmt::format("mean {}, longest {}", readable_duration(bus.wait_mean),
                                     readable_duration(bus.wait_max))},
      {"Queue", fmt::format("mean {:.3g} requests, at most {}", bus.queue.mean, bus.queue.longest)},
      {"Fairness",
       fmt::format("{:.4f} (Jain's index of the mean waits: 1 is all alike)", bus.fairness)}};
  if (bus.database_words > 0) {
    rows.emplace_back("Shared database", fmt::format("{} transfers read it", bus.database_words));
  }
  if (bus.longest_wait.time.count() > 0) {
    rows.emplace_back("Longest wait", fmt::format("{} after {}, behind {}", bus.longest_wait.master,
                                                  readable_duration(bus.longest_wait.requested_at),
                                                  bus.longest_wait.behind));
  }
  return definitions(rows);
}

/// What the bus does with its time.
Html shares(const BusStatistics& bus) {
  PageTable table{"Shares of the frame time of the bus; they sum to one",
                  {{"state"}, {"share", true}, {"meaning"}},
                  {}};
  for_each_field<BusShares>([&](const auto& field) {
    table.rows.push_back({field.name, percent(bus.shares.*field.member, 3), field.description});
  });
  return table_element(table);
}

Html masters(const BusStatistics& bus) {
  PageTable table{"Waits of each bus master",
                  {{"master"},
                   {"transfers", true},
                   {"waited", true},
                   {"50 % at most", true},
                   {"90 %", true},
                   {"99 %", true},
                   {"99.9 %", true},
                   {"longest", true}},
                  {}};
  for (const MasterStatistics& master : bus.masters) {
    const WaitQuantiles& quantiles = master.wait_quantiles;
    table.rows.push_back(
        {master.name, std::to_string(master.transfers), readable_duration(master.wait),
         readable_duration(quantiles.half), readable_duration(quantiles.nine_of_10),
         readable_duration(quantiles.nine_of_100), readable_duration(quantiles.nine_of_1000),
         readable_duration(master.wait_max)});
  }
  return table_element(table);
}

/// The histogram of all masters' waits, as columns and as a table.
Html waits(const BusStatistics& bus) {
  std::map<std::pair<models::Duration, models::Duration>, std::int64_t> buckets;
  for (const MasterStatistics& master : bus.masters) {
    for (const WaitBucket& bucket : master.waits) {
      buckets[{bucket.from, bucket.to}] += bucket.count;
    }
  }
  if (buckets.empty()) {
    return {};
  }
  Chart chart{"waits-chart",
              "Waits for the bus, all masters together",
              "The table below has it.",
              ChartKind::columns,
              "wait, from",
              "accesses"};
  chart.is_logarithmic_y = true;
  chart.series.push_back({"accesses", {}, {}});
  PageTable table{
      "Histogram of the waits for the bus", {{"from", true}, {"to", true}, {"accesses", true}}, {}};
  for (const auto& [edges, count] : buckets) {
    chart.labels.push_back(readable_duration(edges.first));
    chart.series.front().values.push_back(static_cast<double>(count));
    table.rows.push_back(
        {readable_duration(edges.first), readable_duration(edges.second), std::to_string(count)});
  }
  return chart_element(chart) + folded("The histogram as a table", table_element(table));
}

Html queue(const Statistics& statistics) {
  PageTable table{"How long the queue of requests had which length",
                  {{"requests", true}, {"time s", true}, {"of the frame", true}},
                  {}};
  for (const QueueTime& row : statistics.bus.queue.times) {
    table.rows.push_back(
        {std::to_string(row.length), format_seconds(row.time),
         percent(share_of(in_seconds(row.time), in_seconds(statistics.frame.time)), 4)});
  }
  return table.rows.empty() ? Html{} : table_element(table);
}

}  // namespace

Html bus_section(const RunResults& results) {
  const BusStatistics& bus = results.statistics.bus;
  return figures_of(bus) + shares(bus) + bus_over_time(results) + masters(bus) + wait_matrix(bus) +
         waits(bus) + queue(results.statistics);
}

}  // namespace maquette::sim
