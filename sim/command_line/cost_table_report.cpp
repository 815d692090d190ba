#include "sim/command_line/cost_table_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "sim/database/scene_report.hpp"
#include "sim/machine/cost_fields.hpp"
#include "sim/scene/shipped_descriptions.hpp"

namespace maquette::sim {

namespace {

/// A kind of cost tables, and the operations that its tables are of.
struct CostTableKind {
  const char* name;  ///< of the folder, and of the key that names a table
  std::size_t first;
  std::size_t end;
  const char* meaning;
};

constexpr CostTableKind k_kinds[] = {
    {"arithmetic", 0, firmware::k_arithmetic_count, "operations of arithmetic"},
    {"program", firmware::k_arithmetic_count, firmware::k_operation_count,
     "events of the process, besides arithmetic"}};

bool is_shipped(const std::string& name, const std::string& data_directory, const char* kind) {
  const std::vector<ShippedDescription> shipped = shipped_descriptions(data_directory, kind);
  return std::any_of(shipped.begin(), shipped.end(),
                     [&name](const ShippedDescription& one) { return one.name == name; });
}

/// The prototype with this table in place of its own, then with what else is asked for.
Machine machine_with(const std::string& name, const CostTableKind& kind,
                     DescriptionSources sources) {
  sources.overrides.insert(sources.overrides.begin(), fmt::format("board.{}={}", kind.name, name));
  std::vector<InputFile> files;
  return load_machine(sources, files);
}

std::vector<std::string> row_of(const Machine& machine, std::size_t i) {
  const models::ArithmeticCosts& costs = machine.parameters.board.arithmetic;
  const models::OperationCost& cost = costs.operations[i];
  const CostSource& source = machine.tables.sources[i];
  return {firmware::k_operation_names[i],
          fmt::format("{}", cost.clocks),
          fmt::format("{}", cost.reads),
          fmt::format("{}", cost.writes),
          costs.called[i] ? "called" : "in line",
          confidence_marks().write(source.mark).text,
          source.text};
}

void add_rows(const Machine& machine, const CostTableKind& kind, Table& table) {
  for (std::size_t operation = kind.first; operation < kind.end; ++operation) {
    table.rows.push_back(row_of(machine, operation));
  }
}

Table headings() {
  return {{{"operation", "", ""},
           {"clocks", "", "without wait states"},
           {"reads", "", "16-bit bus reads among them"},
           {"writes", "", "16-bit bus writes among them"},
           {"called", "", ""},
           {"mark", "", ""},
           {"source", "", ""}},
          {}};
}

}  // namespace

bool names_cost_table(const std::string& name, const std::string& data_directory) {
  constexpr const char* k_described[] = {"scenes", "machines", "studies"};
  return !std::filesystem::exists(name) &&
         std::none_of(std::begin(k_described), std::end(k_described),
                      [&](const char* kind) { return is_shipped(name, data_directory, kind); }) &&
         std::any_of(std::begin(k_kinds), std::end(k_kinds), [&](const CostTableKind& kind) {
           return is_shipped(name, data_directory, kind.name);
         });
}

Table cost_table(const std::string& name, const DescriptionSources& sources) {
  Table table = headings();
  for (const CostTableKind& kind : k_kinds) {
    if (is_shipped(name, sources.data_directory, kind.name)) {
      add_rows(machine_with(name, kind, sources), kind, table);
    }
  }
  return table;
}

std::string cost_table_report(const std::string& name, const DescriptionSources& sources) {
  std::string text;
  for (const CostTableKind& kind : k_kinds) {
    if (!is_shipped(name, sources.data_directory, kind.name)) {
      continue;
    }
    const Machine machine = machine_with(name, kind, sources);
    text += fmt::format(
        "{}Cost table {}: {}, as `{}` of a board or unit; R read, M measured, W widely stated, I "
        "inferred\n{}",
        text.empty() ? "" : "\n", name, kind.meaning, kind.name,
        cost_lines(machine.parameters.board.arithmetic, machine.tables, kind.first, kind.end));
    text += fmt::format("  its keys: maquette describe --keys {}\n", kind.name);
  }
  return text;
}

}  // namespace maquette::sim
