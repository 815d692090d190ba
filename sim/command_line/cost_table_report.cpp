#include "sim/command_line/cost_table_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "sim/scene/shipped_descriptions.hpp"

namespace maquette::sim {

namespace {

/// A kind of cost tables, and the operations that its tables are of.
struct CostTableKind {
  const char* name;  ///< of the folder, and of the key that names a table
  int first;
  int end;
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

std::vector<std::string> row_of(const Machine& machine, int operation) {
  const auto i = static_cast<std::size_t>(operation);
  const models::ArithmeticCosts& costs = machine.parameters.board.arithmetic;
  const models::OperationCost& cost = costs.operations[i];
  const CostSource& source = machine.tables.sources[i];
  constexpr const char* k_marks = "RMWI";
  return {firmware::k_operation_names[i],
          fmt::format("{}", cost.clocks),
          fmt::format("{}", cost.reads),
          fmt::format("{}", cost.writes),
          costs.called[i] ? "call" : "in line",
          std::string(1, k_marks[static_cast<int>(source.mark)]),
          source.text};
}

void add_rows(const Machine& machine, const CostTableKind& kind, Table& table) {
  for (int operation = kind.first; operation < kind.end; ++operation) {
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

std::string text_of(const Table& table) {
  std::string text;
  std::string before;
  for (const std::vector<std::string>& row : table.rows) {
    text += fmt::format("  {:<18}{:>9}{:>9}{:>9}  {:<8}{}  {}\n", row[0], row[1], row[2], row[3],
                        row[4], row[5], row[6] == before ? "likewise" : row[6]);
    before = row[6];
  }
  return text;
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
    Table table = headings();
    add_rows(machine_with(name, kind, sources), kind, table);
    text += fmt::format(
        "{}Cost table {}: {}, as `{}` of a board or unit\n"
        "  {:<18}{:>9}{:>9}{:>9}  {:<8}source: R read, M measured, W widely stated, I inferred\n{}",
        text.empty() ? "" : "\n", name, kind.meaning, kind.name, "operation", "clocks", "reads",
        "writes", "", text_of(table));
    text += fmt::format("  its keys: maquette describe --keys {}\n", kind.name);
  }
  return text;
}

}  // namespace maquette::sim
