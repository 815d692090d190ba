#include "sim/command_line/table_output.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace maquette::sim {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::string& cell) {
  if (cell.empty()) {
    return nullptr;
  }
  Json value = Json::parse(cell, nullptr, false);
  return value.is_number() ? value : Json(cell);
}

}  // namespace

void add_format_option(CLI::App& verb, TableFormat& format) {
  static const std::map<std::string, TableFormat> names{
      {"text", TableFormat::text}, {"json", TableFormat::json}, {"csv", TableFormat::csv}};
  verb.add_option("--format", format, "how the table is printed: text, json or csv")
      ->transform(CLI::CheckedTransformer(names).description(""))
      ->type_name("FORMAT");
}

std::string table_json(const Table& table) {
  Json rows = Json::array();
  for (const std::vector<std::string>& cells : table.rows) {
    Json row = Json::object();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      row[table.columns[i].name] = json_of(cells[i]);
    }
    rows.push_back(std::move(row));
  }
  // Cells may hold bytes that are not UTF-8: they are replaced, not refused.
  return rows.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string in_format(TableFormat format, const std::function<std::string()>& text,
                      const std::function<Table()>& table) {
  switch (format) {
    case TableFormat::text:
      return text();
    case TableFormat::json:
      return table_json(table());
    case TableFormat::csv:
      break;
  }
  return table_csv(table());
}

}  // namespace maquette::sim
