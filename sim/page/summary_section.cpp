#include <fmt/format.h>

#include "sim/fields/quantity.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

std::string times_from(const CostStatistics& costs, const Machine& machine) {
  constexpr double k_percent = 100;
  if (costs.from == "calibration") {
    return fmt::format(
        "the firmware's counted work, at the costs of {} pixels whose program was executed (their "
        "sum {:+.2f} %, one pixel typically {:.1f} %)",
        costs.pixels, k_percent * costs.sum_error, k_percent * costs.typical_error);
  }
  if (costs.from == "execution") {
    return "the boards' program, executed instruction by instruction";
  }
  return fmt::format("the firmware's counted work, at the costs of the tables {} and {}",
                     machine.tables.arithmetic, machine.tables.program);
}

}  // namespace

Html summary_section(const RunResults& results) {
  const FrameStatistics& frame = results.statistics.frame;
  const UsefulZone& zone = results.statistics.useful_zone;
  const Machine& machine = results.description.machine;
  std::vector<std::pair<std::string, std::string>> rows{
      {"Frame time", readable_duration(frame.time)}};
  if (results.statistics.partial) {
    rows.emplace_back("PARTIAL", results.statistics.end_reason);
  } else if (const auto& paper = results.description.scene.paper_time) {
    rows.emplace_back(
        "The paper",
        fmt::format("{}; {}", format_quantity(paper->value.count(), WholeDimension::time),
                    paper->source));
  }
  rows.insert(
      rows.end(),
      {{"Loading", readable_duration(frame.load) + ", before the frame"},
       {"Preprocessing", readable_duration(frame.preprocess)},
       {"Synthesis", readable_duration(frame.synthesis)},
       {"Picture", fmt::format("{} x {} pixels; {} of {} synthesised", frame.width, frame.height,
                               frame.pixels_synthesised, frame.pixels_total)},
       {"Useful zone",
        fmt::format("{} x {} pixels at ({}, {})", zone.width, zone.height, zone.column, zone.row)},
       {"Machine", fmt::format("{}: {} {}, bus {}", machine.name, machine.parameters.boards.size(),
                               machine.parameters.boards.size() == 1 ? "board" : "boards",
                               machine.parameters.bus.level.name)},
       {"Bus", fmt::format("{} transfers, {} occupied", results.statistics.bus.transfers,
                           percent(results.statistics.bus.occupied, 3))},
       {"Times from", times_from(results.statistics.costs, machine)}});
  return definitions(rows);
}

}  // namespace maquette::sim
