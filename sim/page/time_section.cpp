#include <fmt/format.h>

#include <algorithm>

#include "sim/page/chart.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

struct BoardState {
  const char* name;
  models::Duration BoardStatistics::*time;
};

constexpr BoardState k_board_states[] = {{"compute", &BoardStatistics::compute},
                                         {"wait for the bus", &BoardStatistics::wait_grant},
                                         {"transfer", &BoardStatistics::transfer},
                                         {"idle", &BoardStatistics::idle}};

/// Until function units had done something; none on a machine without.
models::Duration wait_for_units(const Statistics& statistics, std::size_t board) {
  return statistics.units ? statistics.units->boards[board].wait : models::Duration::zero();
}

Html board_table(const Statistics& statistics) {
  PageTable table{"States of the boards; those of each sum to the frame time",
                  {{"board"},
                   {"pixels", true},
                   {"compute s", true},
                   {"wait s", true},
                   {"transfer s", true},
                   {"idle s", true},
                   {"computes", true}},
                  {}};
  if (statistics.units) {
    table.columns.push_back({"wait for units s", true});
  }
  for (std::size_t i = 0; i < statistics.boards.size(); ++i) {
    const BoardStatistics& board = statistics.boards[i];
    std::vector<std::string> row{board.name, std::to_string(board.pixels)};
    for (const BoardState& state : k_board_states) {
      row.push_back(four_decimals(board.*state.time));
    }
    row.push_back(percent(share_of(in_seconds(board.compute), in_seconds(statistics.frame.time))));
    if (statistics.units) {
      row.push_back(four_decimals(wait_for_units(statistics, i)));
    }
    table.rows.push_back(row);
  }
  return table_element(table);
}

Html board_chart(const Statistics& statistics) {
  Chart chart{"boards-chart",
              "Time of the frame by board and state",
              "The table below has it.",
              ChartKind::bars,
              "s of the frame",
              ""};
  for (const BoardState& state : k_board_states) {
    chart.series.push_back({state.name, {}, {}});
    for (const BoardStatistics& board : statistics.boards) {
      chart.series.back().values.push_back(in_seconds(board.*state.time));
    }
  }
  for (const BoardStatistics& board : statistics.boards) {
    chart.labels.push_back(board.name);
  }
  if (statistics.units) {
    chart.series.push_back({"wait for units", {}, {}});
    for (std::size_t i = 0; i < statistics.boards.size(); ++i) {
      chart.series.back().values.push_back(in_seconds(wait_for_units(statistics, i)));
    }
  }
  return chart_element(chart);
}

Html claims(const Statistics& statistics) {
  PageTable table{"Units claimed on demand",
                  {{"board"}, {"units", true}, {"time", true}, {"tries at a taken lock", true}},
                  {}};
  for (const BoardStatistics& board : statistics.boards) {
    if (board.claims > 0) {
      table.rows.push_back({board.name, std::to_string(board.claims - 1),
                            readable_duration(board.claim),
                            std::to_string(board.claim_failed_tries)});
    }
  }
  return table.rows.empty() ? Html{} : table_element(table);
}

struct NamedTime {
  std::string name;
  models::Duration time;
};

std::vector<NamedTime> function_times(const FunctionStatistics& functions) {
  std::vector<NamedTime> times;
  times.reserve(static_cast<std::size_t>(k_told_function_count));
  for (int function = 0; function < k_told_function_count; ++function) {
    times.push_back({function_name(function),
                     functions.by_function.values[static_cast<std::size_t>(function)]});
  }
  std::stable_sort(times.begin(), times.end(), [](const NamedTime& first, const NamedTime& second) {
    return first.time > second.time;
  });
  return times;
}

std::vector<NamedTime> ray_times(const FunctionStatistics& functions) {
  std::vector<NamedTime> times;
  for_each_field<RayTimes>([&](const auto& ray) {
    times.push_back({ray.name, functions.by_ray.*ray.member});
  });
  return times;
}

/// Times that sum to the whole of a board's work, as bars and as a table.
Html parts_of_work(const std::string& id, const std::string& title, const std::string& heading,
                   const std::vector<NamedTime>& times, models::Duration whole) {
  Chart chart{id, title, "The table below has it.", ChartKind::bars, "s of a board's work", ""};
  chart.series.push_back({"time", {}, {}});
  PageTable table{title, {{heading}, {"time s", true}, {"of work", true}}, {}};
  for (const NamedTime& part : times) {
    if (part.time > models::Duration::zero()) {
      chart.labels.push_back(part.name);
      chart.series.front().values.push_back(in_seconds(part.time));
      table.rows.push_back({part.name, four_decimals(part.time),
                            percent(share_of(in_seconds(part.time), in_seconds(whole)))});
    }
  }
  return chart_element(chart) + table_element(table);
}

}  // namespace

Html time_section(const RunResults& results) {
  const Statistics& statistics = results.statistics;
  const FunctionStatistics& functions = statistics.functions;
  Html content = board_chart(statistics) + board_table(statistics) +
                 paragraph(fmt::format("The longest at work is {:.2f} % above the mean.",
                                       100 * statistics.frame.imbalance)) +
                 claims(statistics);
  if (functions.time == models::Duration::zero()) {
    return content + paragraph("Time by function: " + functions.from + ".");
  }
  content += element("h3", "By function of the process");
  content += paragraph("From " + functions.from + "; a board's work in the mean.");
  content += parts_of_work("functions-chart", "Work of a board by function", "function",
                           function_times(functions), functions.time);
  content += element("h3", "By kind of ray");
  content += parts_of_work("rays-chart", "Work of a board by kind of ray", "in rays",
                           ray_times(functions), functions.time);
  return content;
}

}  // namespace maquette::sim
