#include "sim/sweep/derivation.hpp"

#include <map>
#include <optional>

#include "sim/sweep/measure.hpp"

namespace maquette::sim {
namespace {

using Row = std::vector<std::string>;

/// The values of all varied parameters but one.
std::vector<std::string> series_of(const Table& table, const Row& row, const DerivedColumn& column,
                                   const std::vector<Axis>& axes) {
  std::vector<std::string> values;
  for (const Axis& axis : axes) {
    if (axis.path != column.over) {
      values.push_back(row[*table.find(axis.path)]);
    }
  }
  return values;
}

/// A value of a row: of a column, or a number that stands for itself.
std::optional<double> value_in_row(const Table& table, const Row& row, const std::string& name) {
  const auto place = table.find(name);
  return place && *place < row.size() ? number_in(row[*place]) : number_in(name);
}

std::optional<double> quotient(std::optional<double> above, std::optional<double> below) {
  return above && below && *below != 0 ? std::optional{*above / *below} : std::nullopt;
}

std::optional<double> derived(const Table& table, const Row& row, const Row& first,
                              const DerivedColumn& column) {
  const auto value = [&](const Row& of_row, const std::string& name) {
    return value_in_row(table, of_row, name);
  };
  switch (column.derivation) {
    case Derivation::speed_up:
      return quotient(value(first, column.of), value(row, column.of));
    case Derivation::efficiency:
      return quotient(quotient(value(first, column.of), value(row, column.of)),
                      quotient(value(row, column.over), value(first, column.over)));
    case Derivation::ratio:
      break;
  }
  return quotient(value(row, column.of), value(row, column.over));
}

}  // namespace

void add_derived_column(Table& table, const DerivedColumn& column, const std::vector<Axis>& axes) {
  std::map<std::vector<std::string>, std::size_t> first_rows;
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    const auto first = first_rows.try_emplace(series_of(table, row, column, axes), i).first;
    const std::optional<double> value = derived(table, row, table.rows[first->second], column);
    cells.push_back(value ? write_measure({*value, ""}) : "");
  }
  table.columns.push_back({column.name, column.unit, column.sentence});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    table.rows[i].push_back(cells[i]);
  }
}

}  // namespace maquette::sim
