#include <fmt/format.h>

#include <map>

#include "sim/machine/machine_description.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/run_sections.hpp"
#include "sim/scene/scene_description.hpp"

namespace maquette::sim {
namespace {

std::map<std::string, std::string> values_by_path(const Machine& machine) {
  std::map<std::string, std::string> values;
  for (const ParameterRow& row : list_parameters(machine)) {
    values[row.path] = row.value;
  }
  return values;
}

Html differences(const std::vector<ParameterRow>& rows, const Machine& prototype) {
  const std::map<std::string, std::string> values = values_by_path(prototype);
  PageTable table{"What differs from the prototype, " + prototype.name,
                  {{"parameter"}, {"prototype"}, {"here"}, {"meaning"}},
                  {}};
  for (const ParameterRow& row : rows) {
    const auto own = values.find(row.path);
    const std::string there = own == values.end() ? "" : own->second;
    if (there != row.value) {
      table.rows.push_back({row.path, there.empty() ? "not said" : there,
                            row.value.empty() ? "not said" : row.value, row.sentence});
    }
  }
  return table.rows.empty() ? paragraph("The machine is the prototype, " + prototype.name + ".")
                            : table_element(table);
}

Html parameters(const std::string& caption, const std::vector<ParameterRow>& rows) {
  PageTable table{
      caption, {{"parameter"}, {"value"}, {"meaning"}, {"allowed"}, {"source of the figure"}}, {}};
  table.is_long = true;
  for (const ParameterRow& row : rows) {
    if (!row.value.empty()) {
      table.rows.push_back({row.path, row.value, row.sentence, row.range, row.source});
    }
  }
  return folded(fmt::format("{}: {} values", caption, table.rows.size()), table_element(table));
}

}  // namespace

Html configuration_section(const RunResults& results) {
  const std::vector<ParameterRow> machine = list_parameters(results.description.machine);
  return differences(machine, results.prototype) +
         paragraph(
             "In the sources, R is read in the document named, M measured on the program, W widely "
             "stated, I inferred or assumed.") +
         parameters("Parameters of the machine", machine) +
         parameters("Parameters of the scene", list_parameters(results.description.scene));
}

}  // namespace maquette::sim
