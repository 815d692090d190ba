#include <fmt/format.h>

#include "sim/page/chart.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

struct UnitState {
  const char* name;
  const char* heading;
  models::Duration FunctionUnitStatistics::*time;
};

constexpr UnitState k_unit_states[] = {
    {"serve", "serves s", &FunctionUnitStatistics::serve},
    {"wait for the bus", "wait s", &FunctionUnitStatistics::wait_grant},
    {"transfer", "transfer s", &FunctionUnitStatistics::transfer},
    {"wait for a place", "wait for a place s", &FunctionUnitStatistics::wait_place},
    {"idle", "idle s", &FunctionUnitStatistics::idle}};

Html states_chart(const UnitsStatistics& units) {
  Chart chart{"units-chart",
              "Time of the frame by unit and state",
              "The table below has it.",
              ChartKind::bars,
              "s of the frame",
              ""};
  for (const UnitState& state : k_unit_states) {
    chart.series.push_back({state.name, {}, {}});
    for (const FunctionUnitStatistics& unit : units.units) {
      chart.series.back().values.push_back(in_seconds(unit.*state.time));
    }
  }
  for (const FunctionUnitStatistics& unit : units.units) {
    chart.labels.push_back(unit.name);
  }
  return chart_element(chart);
}

Html states_table(const UnitsStatistics& units) {
  PageTable table{"States of the units; those of each sum to the frame time",
                  {{"unit"}, {"errands", true}},
                  {}};
  for (const UnitState& state : k_unit_states) {
    table.columns.push_back({state.heading, true});
  }
  table.columns.push_back({"busy", true});
  for (const FunctionUnitStatistics& unit : units.units) {
    std::vector<std::string> row{unit.name, std::to_string(unit.errands)};
    for (const UnitState& state : k_unit_states) {
      row.push_back(four_decimals(unit.*state.time));
    }
    row.push_back(percent(unit.utilisation));
    table.rows.push_back(row);
  }
  return table_element(table);
}

Html queues_table(const UnitsStatistics& units) {
  PageTable table{"Errands that waited for their unit",
                  {{"unit"}, {"waiting in the mean", true}, {"most", true}, {"longest", true}},
                  {}};
  for (const FunctionUnitStatistics& unit : units.units) {
    table.rows.push_back({unit.name, fmt::format("{:.4g}", unit.queue_mean),
                          std::to_string(unit.queue_longest), readable_duration(unit.queued_max)});
  }
  return table_element(table);
}

Html stages_table(const UnitsStatistics& units) {
  PageTable table{"What an errand waits for at each stage",
                  {{"stage"},
                   {"units busy", true},
                   {"for a place, mean", true},
                   {"longest", true},
                   {"in the queue, mean", true}},
                  {}};
  for (const UnitKindStatistics& kind : units.kinds) {
    table.rows.push_back({kind.kind, percent(kind.utilisation), readable_duration(kind.place_mean),
                          readable_duration(kind.place_max), readable_duration(kind.queued_mean)});
  }
  return table_element(table);
}

/// Who waited for whom: boards down, kinds of units across.
Html boards_table(const UnitsStatistics& units) {
  PageTable table{"Boards with nothing to do until units had done something",
                  {{"board"}, {"in all s", true}},
                  {}};
  for (const UnitKindStatistics& kind : units.kinds) {
    table.columns.push_back({kind.kind + " s", true});
  }
  for (const BoardWaits& board : units.boards) {
    std::vector<std::string> row{board.name, four_decimals(board.wait)};
    for (const models::Duration& wait : board.waited_for) {
      row.push_back(four_decimals(wait));
    }
    table.rows.push_back(row);
  }
  return table_element(table);
}

}  // namespace

Html units_section(const RunResults& results) {
  if (!results.statistics.units) {
    return {};
  }
  const UnitsStatistics& units = *results.statistics.units;
  return paragraph(fmt::format(
             "The bottleneck: {}, busy {} of the frame time. The boards are busy {} of it.",
             units.bottleneck, percent(units.bottleneck_utilisation),
             percent(units.board_utilisation))) +
         states_chart(units) + states_table(units) + element("h3", "Queues") + stages_table(units) +
         queues_table(units) + element("h3", "What the boards wait for") + boards_table(units);
}

}  // namespace maquette::sim
