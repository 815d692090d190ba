#include "sim/database/scene_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "sim/database/board_code.hpp"
#include "sim/database/memory_map.hpp"
#include "sim/database/needs.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/database/surface_union_report.hpp"
#include "sim/machine/cost_fields.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/scene/scene_description.hpp"

namespace maquette::sim {

namespace {

std::string joined(const std::vector<std::string>& texts) {
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, ", "));
}

/// What is needed, and what is left out with the code that it would add.
std::string needs_list(const firmware::Needs& needs, const firmware::ProgramCode& code) {
  const std::int64_t linked_bytes = code_bytes(needed_pieces(code, needs));
  std::vector<std::string> needed;
  std::vector<std::string> left_out;
  for (const NamedNeed& need : named_needs(needs)) {
    if (need.is_needed) {
      needed.push_back(need.name);
    } else {
      const std::int64_t added = code_bytes(needed_pieces(code, need.with)) - linked_bytes;
      left_out.push_back(fmt::format("{} ({})", need.name, added));
    }
  }
  return fmt::format(
      "  needed: {}\n  left out: {}; in brackets the bytes of code that each alone would add, all "
      "together save {}\n",
      joined(needed), joined(left_out), code_bytes(all_pieces(code)) - linked_bytes);
}

std::string memory_row(std::int64_t address, std::int64_t bytes, const std::string& text) {
  return fmt::format("  {:06X}  {:>8} bytes  {}\n", address, bytes, text);
}

std::string memory_table(const MemoryMap& map, const Machine& machine) {
  std::string text = "Memory of a board\n";
  const MemoryUse& stack = map.uses.back();
  for (const MemoryUse& use : map.uses) {
    text += use.bytes > 0 && &use != &stack ? memory_row(use.address, use.bytes, use.name) : "";
  }
  const std::int64_t free_bytes = map.ram_bytes - map.used_bytes;
  text += free_bytes >= 0
              ? memory_row(stack.address - free_bytes, free_bytes,
                           fmt::format("free of {}", map.ram_bytes))
              : fmt::format("          {:>8} bytes  too much for {}\n", -free_bytes, map.ram_bytes);
  text += memory_row(stack.address, stack.bytes, stack.name);
  text += fmt::format(
      "  the host loads {} bytes; needed of the work areas: {} of {} crossings, {} of {} waiting "
      "rays, {} of {} bytes of stack\n",
      map.loaded_bytes, map.crossings_needed, machine.crossing_capacity, map.rays_needed,
      machine.ray_capacity, map.stack_needed_bytes, machine.stack_bytes);
  return text;
}

std::string parameter_table(const std::vector<ParameterRow>& rows) {
  std::size_t path_width = 0;
  std::size_t value_width = 0;
  constexpr std::size_t k_widest_value = 28;
  for (const ParameterRow& row : rows) {
    path_width = std::max(path_width, row.path.size());
    value_width = std::max(value_width, std::min(row.value.size(), k_widest_value));
  }
  std::string text;
  for (const ParameterRow& row : rows) {
    text += fmt::format("  {:<{}}  {:<{}}  {}", row.path, path_width, row.value, value_width,
                        row.sentence);
    text += row.range.empty() ? "" : fmt::format("; allowed: {}", row.range);
    text += row.default_value.empty() || row.default_value == row.value
                ? ""
                : fmt::format("; default: {}", row.default_value);
    text += row.source.empty() ? "\n" : fmt::format("; source: {}\n", row.source);
  }
  return text;
}

/// `path` is where the costs stand in the machine.
std::string cost_table(const std::string& path, const models::ArithmeticCosts& costs,
                       const CostTables& tables) {
  const std::string text = fmt::format(
      "Cost table {} ({}.arithmetic.OPERATION.clocks, .reads, .writes), {} bytes of "
      "code; R read, M measured, W widely stated, I inferred\n",
      tables.arithmetic, path, costs.package_bytes);
  return text + cost_lines(costs, tables, 0, costs.operations.size());
}

/// Those of function units with costs of their own.
std::string unit_cost_tables(const Machine& machine) {
  std::string text;
  for (std::size_t kind = 0; kind < machine.unit_tables.size(); ++kind) {
    const models::FunctionUnitParameters& unit = machine.parameters.units.kinds[kind];
    if (unit.number > 0 && unit.costs) {
      text += "\n" + cost_table(std::string("units.") + models::k_unit_kind_names[kind],
                                *unit.costs, machine.unit_tables[kind]);
    }
  }
  return text;
}

/// Whether a parameter is one of those that cost tables show.
bool is_in_cost_table(const ParameterRow& row) {
  const auto starts_with = [&row](std::string_view start) {
    return row.path.compare(0, start.size(), start) == 0;
  };
  return starts_with("board.arithmetic.") ||
         (starts_with("units.") && (row.path.find(".arithmetic.") != std::string::npos ||
                                    row.path.find(".program.") != std::string::npos));
}

}  // namespace

std::string cost_lines(const models::ArithmeticCosts& costs, const CostTables& tables,
                       std::size_t first, std::size_t end) {
  std::string text = fmt::format("  {:<17} {:>8} {:>7} {:>7}  {:<7} {}\n", "operation", "clocks",
                                 "reads", "writes", "", "source");
  for (std::size_t i = first; i < end; ++i) {
    const models::OperationCost& cost = costs.operations[i];
    const CostSource& source = tables.sources[i];
    text += fmt::format("  {:<17} {:>8g} {:>7g} {:>7g}  {:<7} [{}] {}\n",
                        firmware::k_operation_names[i], cost.clocks, cost.reads, cost.writes,
                        costs.called[i] ? "called" : "in line",
                        confidence_marks().write(source.mark).text, source.text);
  }
  return text;
}

std::string scene_report(const Scene& scene, const Machine& machine) {
  const PackedScene<float> packed = packed_scene<float>(scene, picture_format_of(machine));
  const firmware::Database<float> database = packed.database();
  const firmware::NumberFormat numbers = models::numbers_of(machine.parameters.board.arithmetic);
  const MemoryMap map = memory_map_of(packed, machine);
  std::string text = fmt::format("Scene {}\n", scene.name);
  text += fmt::format("  {} primitives, {} composites, {} surfaces, {} lights; a tree {} high\n",
                      database.leaf_count, database.composite_count, database.surface_count,
                      database.light_count, packed.tree_height);
  text += needs_list(database.needs, program_code(numbers));
  text += "\n" + memory_table(map, machine);
  return text + surface_union_report(packed);
}

std::string scene_parameter_report(const Scene& scene) {
  return "Parameters of the scene\n" + parameter_table(list_parameters(scene));
}

std::string machine_report(const Machine& machine) {
  std::vector<ParameterRow> rows =
      with_defaults(list_parameters(machine), list_parameters(default_machine()));
  rows.erase(std::remove_if(rows.begin(), rows.end(), is_in_cost_table), rows.end());
  return fmt::format("Machine {}\n{}\n{}{}", machine.name, parameter_table(rows),
                     cost_table("board", machine.parameters.board.arithmetic, machine.tables),
                     unit_cost_tables(machine));
}

}  // namespace maquette::sim
