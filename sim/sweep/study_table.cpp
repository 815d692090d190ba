#include "sim/sweep/study_table.hpp"

#include <string>

#include "sim/report/scalar_statistics.hpp"
#include "sim/sweep/derivation.hpp"
#include "sim/sweep/measure.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {
namespace {

/// Puts numbers of one kind into the unit of the first; leaves other texts alone.
TableColumn unify(const std::string& name, std::vector<std::string>& texts) {
  const std::optional<Measure> first = texts.empty() ? std::nullopt : read_measure(texts.front());
  if (!first) {
    return {name, "", ""};
  }
  std::vector<std::string> numbers;
  for (const std::string& text : texts) {
    const std::optional<Measure> measure = read_measure(text);
    const std::optional<double> value = measure ? value_in(*measure, first->unit) : std::nullopt;
    if (!value) {
      return {name, "", ""};
    }
    numbers.push_back(write_measure({*value, ""}));
  }
  texts = std::move(numbers);
  return {name, first->unit, ""};
}

/// The varied parameters, in the order of the axes.
void add_parameters(Table& table, const StudyPoints& points) {
  const std::vector<Axis>& axes = points.study().axes;
  std::vector<std::vector<std::string>> cells(axes.size());
  for (int point = 0; point < points.size(); ++point) {
    const std::vector<PointParameter> parameters = points.parameters(point);
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      cells[axis].push_back(parameters[axis].value);
    }
  }
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    table.columns.push_back(unify(axes[axis].path, cells[axis]));
    table.columns.back().sentence = points.sentence(axis);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      table.rows[row].push_back(cells[axis][row]);
    }
  }
}

std::vector<std::string> outcome_cells(const std::optional<PointResult>& result) {
  if (!result) {
    return {"missing", "not run yet"};
  }
  return result->statistics ? std::vector<std::string>{"done", ""}
                            : std::vector<std::string>{"failed", result->failure};
}

void add_statistics(Table& table, const PointResults& results) {
  for (const ScalarStatistic& scalar : scalar_statistics({})) {
    table.columns.push_back({scalar.name, scalar.unit, scalar.sentence});
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<std::string>& cells = table.rows[row];
    if (results[row] && results[row]->statistics) {
      for (ScalarStatistic& scalar : scalar_statistics(*results[row]->statistics)) {
        cells.push_back(std::move(scalar.text));
      }
    }
    cells.resize(table.columns.size());
  }
}

void require_column(const Table& table, const std::string& name, const YamlPlace& place) {
  if (table.find(name)) {
    return;
  }
  std::vector<std::string_view> names;
  for (const TableColumn& column : table.columns) {
    names.emplace_back(column.name);
  }
  throw DescriptionError(place.position(),
                         "the table has no column `" + name + "`; " + allowed_names(name, names));
}

void check_plot(const Table& table, const Plot& plot, StudyDesign design) {
  if (needs_single_axes(plot.kind) && !varies_single_axes(design)) {
    throw DescriptionError(plot.place.position(), "a tornado plot needs the design one_at_a_time");
  }
  require_column(table, plot.y, plot.place);
  if (needs_x(plot.kind)) {
    require_column(table, plot.x, plot.place);
  }
  for (const std::string& optional : {plot.series, plot.band}) {
    if (!optional.empty()) {
      require_column(table, optional, plot.place);
    }
  }
}

}  // namespace

Table study_table(const StudyPoints& points, const PointResults& results) {
  Table table;
  table.columns.push_back({"point", "", "number"});
  for (int point = 0; point < points.size(); ++point) {
    table.rows.push_back({std::to_string(point)});
  }
  add_parameters(table, points);
  table.columns.push_back({"status", "", ""});
  table.columns.push_back({"reason", "", ""});
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::string& cell : outcome_cells(results[row])) {
      table.rows[row].push_back(std::move(cell));
    }
  }
  add_statistics(table, results);
  for (const DerivedColumn& column : points.study().columns) {
    add_derived_column(table, column, points.study().axes);
  }
  return table;
}

void check_columns(const StudyPoints& points) {
  const Table table = study_table(points, PointResults(static_cast<std::size_t>(points.size())));
  for (const DerivedColumn& column : points.study().columns) {
    require_column(table, column.of, column.place);
    if (!takes_number(column.derivation) || !number_in(column.over)) {
      require_column(table, column.over, column.place);
    }
  }
  for (const Plot& plot : points.study().plots) {
    check_plot(table, plot, points.study().design);
  }
}

}  // namespace maquette::sim
