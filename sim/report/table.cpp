#include "sim/report/table.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace maquette::sim {
namespace {

std::string csv_cell(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) {
    return cell;
  }
  std::string quoted = "\"";
  for (const char letter : cell) {
    quoted.append(letter == '"' ? 2 : 1, letter);
  }
  return quoted + "\"";
}

}  // namespace

std::optional<std::size_t> Table::find(const std::string& name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const TableColumn& column) { return column.name == name; });
  return found == columns.end() ? std::nullopt
                                : std::optional{static_cast<std::size_t>(found - columns.begin())};
}

std::string heading_of(const TableColumn& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

std::string table_csv(const Table& table) {
  std::string text;
  for (const TableColumn& column : table.columns) {
    text.append(text.empty() ? "" : ",").append(csv_cell(heading_of(column)));
  }
  text += '\n';
  for (const std::vector<std::string>& row : table.rows) {
    const char* separator = "";
    for (const std::string& cell : row) {
      text.append(separator).append(csv_cell(cell));
      separator = ",";
    }
    text += '\n';
  }
  return text;
}

std::optional<double> number_in(const std::string& cell) {
  double value = 0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (cell.empty() || result.ec != std::errc{} || result.ptr != cell.data() + cell.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace maquette::sim
