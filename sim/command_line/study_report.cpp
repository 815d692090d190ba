#include "sim/command_line/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/command_line/common_options.hpp"
#include "sim/sweep/study_defaults.hpp"
#include "sim/sweep/study_description.hpp"
#include "sim/sweep/study_table.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_vary = "vary";

StudyPoints points_of(const InputFile& file) {
  Study study = read_study(parse_yaml(file));
  std::vector<InputFile> input_files;
  inline_files(study, data_directory(), input_files);
  complete(study);
  StudyPoints points(std::move(study), data_directory());
  check_columns(points);
  return points;
}

Table empty_table(const StudyPoints& points) {
  return study_table(points, PointResults(static_cast<std::size_t>(points.size())));
}

const char* word_of(Derivation derivation) {
  switch (derivation) {
    case Derivation::speed_up:
      return "speed_up";
    case Derivation::efficiency:
      return "efficiency";
    case Derivation::ratio:
      break;
  }
  return "ratio";
}

std::string line_of(const std::string& name, const std::string& text) {
  return fmt::format("  {:<28} {}\n", name, text);
}

}  // namespace

bool describes_study(const InputFile& file) { return parse_yaml(file).find(k_vary) != nullptr; }

std::string study_report(const InputFile& file) {
  const StudyPoints points = points_of(file);
  const Study& study = points.study();
  std::string text = fmt::format("Study {}: {}\n  {} points\n\nVaried\n", study.name,
                                 study.sentence, points.size());
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    text += line_of(study.axes[axis].path, points.sentence(axis));
  }
  text += study.columns.empty() ? "" : "\nDerived columns of its table\n";
  for (const DerivedColumn& column : study.columns) {
    text += line_of(column.name, fmt::format("{} of {} over {}: {}", word_of(column.derivation),
                                             column.of, column.over, column.sentence));
  }
  text += study.plots.empty() ? "" : "\nPlots\n";
  for (const Plot& plot : study.plots) {
    text += line_of(plot.y, (plot.x.empty() ? "" : "against " + plot.x) +
                                (plot.series.empty() ? "" : ", a series for each " + plot.series));
  }
  return text + fmt::format(
                    "\nThe table has {} columns, the statistics of each run among them: "
                    "--format csv lists them\n",
                    empty_table(points).columns.size());
}

Table column_table(const InputFile& file) {
  const StudyPoints points = points_of(file);
  const Study& study = points.study();
  Table table;
  for (const char* name : {"column", "kind", "unit", "meaning"}) {
    table.columns.push_back({name, "", ""});
  }
  for (const TableColumn& column : empty_table(points).columns) {
    const auto is_derived = [&column](const DerivedColumn& one) { return one.name == column.name; };
    const auto is_varied = [&column](const Axis& axis) { return axis.path == column.name; };
    const bool derived = std::any_of(study.columns.begin(), study.columns.end(), is_derived);
    const bool varied = std::any_of(study.axes.begin(), study.axes.end(), is_varied);
    table.rows.push_back({column.name,
                          derived  ? "derived"
                          : varied ? "varied"
                                   : "of a run",
                          column.unit, column.sentence});
  }
  return table;
}

}  // namespace maquette::sim
