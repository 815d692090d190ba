#include "sim/sweep/study_results.hpp"

#include <fmt/format.h>

#include "sim/plot/gnuplot.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/sweep/plot_script.hpp"

namespace maquette::sim {
namespace {

void draw_plots(const StudyPoints& points, const Table& table,
                const std::filesystem::path& directory) {
  if (points.study().plots.empty()) {
    return;
  }
  PlotData data{points.study(), table, {}};
  for (int point = 0; point < points.size(); ++point) {
    data.prototypes.push_back(points.is_prototype(points.description(point)));
  }
  for (const Plot& plot : points.study().plots) {
    draw(directory, file_name_of(plot), plot_script(plot, data));
  }
}

}  // namespace

StudyOutcome gather(const StudyPoints& points, const StudyDirectory& directory) {
  StudyOutcome outcome;
  PointResults results;
  for (int point = 0; point < points.size(); ++point) {
    const std::optional<PointResult>& result = results.emplace_back(directory.read(point));
    int& count = !result ? outcome.missing : result->statistics ? outcome.done : outcome.failed;
    ++count;
  }
  outcome.table = study_table(points, results);
  write_files(directory.path(), {{"table.csv", table_csv(outcome.table)}});
  draw_plots(points, outcome.table, directory.path() / "plots");
  return outcome;
}

std::string outcome_report(const StudyOutcome& outcome) {
  std::string text = fmt::format("{} points done", outcome.done);
  text += outcome.failed > 0 ? fmt::format(", {} failed", outcome.failed) : "";
  text += outcome.missing > 0 ? fmt::format(", {} missing", outcome.missing) : "";
  return text;
}

}  // namespace maquette::sim
